#pragma once

#include <array>

#include "schemes/curve/vec.hpp"

namespace kappabench {

/// The highest derivative that a Segment can be asked for: enough for the second arc-length
/// derivative of curvature.
inline constexpr int max_jet_order = 4;

/// Position and derivatives of a curve with respect to its parameter t: `d[k]` is the k-th derivative,
/// `d[0]` the position. Entries above the order that was asked for are unspecified.
struct Jet {
  std::array<Vec2, max_jet_order + 1> d;

  [[nodiscard]] const Vec2& position() const { return d[0]; }
};

/// |c'(t)|, arc length per unit of t. Needs order 1.
[[nodiscard]] double speed(const Jet& jet);

/// Signed curvature, 1/length, positive where the curve turns left. Needs order 2.
/// Infinite or NaN where the speed vanishes (a cusp): callers that may meet one test the speed first.
[[nodiscard]] double curvature(const Jet& jet);

/// d kappa / ds with s the arc length, 1/length^2. Needs order 3. Not defined where the speed vanishes.
[[nodiscard]] double curvature_derivative(const Jet& jet);

/// d^2 kappa / ds^2, 1/length^3. Needs order 4. Not defined where the speed vanishes.
[[nodiscard]] double curvature_second_derivative(const Jet& jet);

/// Direction angle of c'(t) against the x axis in (-pi, pi], radians. Needs order 1.
[[nodiscard]] double tangent_angle(const Jet& jet);

}  // namespace kappabench
