#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/curve/jet.hpp"

namespace kappabench::miura {

// The bases that Miura 2022, Appendix C looks at, degenerated to three control points by adding the two inner blending
// functions: c(t) = A_0(t) P_0 + (1 - A_0(t) - A_2(t)) P_1 + A_2(t) P_2 on [0, 1].

/// A function with its first two derivatives.
struct Blending {
  double value, first, second;
};

struct DegenerateBasis {
  std::string id;
  std::string title;
  std::string brief;               ///< for the head of a small figure
  std::string place;               ///< where it stands in the paper
  std::vector<double> parameters;  ///< shape parameters to look at: the ends of the allowed range and some between
  std::function<Blending(double t, double alpha)> last;  ///< A_2; A_0(t) = A_2(1 - t) in every one of these bases
};

/// C-Bézier, cubic alternative, cubic trigonometric Bézier, alpha-beta-Bernstein-like, quasi-cubic trigonometric,
/// and the two that the schemes here use: constrained cubic Bernstein (alpha is a) and quadratic trigonometric.
[[nodiscard]] const std::vector<DegenerateBasis>& degenerate_bases();
/// The one with this id, which there must be.
[[nodiscard]] const DegenerateBasis& basis_named(std::string_view id);

/// A_0, A_1, A_2 at t.
[[nodiscard]] std::array<Blending, 3> blending_functions(const DegenerateBasis& basis, double alpha, double t);

/// The curve over three control points, with two derivatives.
[[nodiscard]] Jet degenerate_curve(const DegenerateBasis& basis, double alpha, const std::array<Vec2, 3>& control,
                                   double t);

}  // namespace kappabench::miura
