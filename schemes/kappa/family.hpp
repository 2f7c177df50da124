#pragma once

#include <span>
#include <string>
#include <vector>

#include "schemes/api/scheme.hpp"

namespace kappabench::kappa {

/// What the segments of a curve are: `quadratic` is `cubic` with a = 2/3 throughout, written with three
/// control points.
enum class SegmentKind { quadratic, cubic, trigonometric };

/// How the equations are solved: by the damped Newton cascade, or by the papers' own Algorithm 1 with at most
/// `max_iterations` steps.
struct Iteration {
  bool published = false;
  int max_iterations = 50;
};

/// What the three schemes share: the parameters `iteration` and `max_iterations`, and the traits.
[[nodiscard]] std::vector<ParameterSpec> iteration_parameters();
[[nodiscard]] SchemeTraits family_traits();
[[nodiscard]] Iteration iteration_of(const Parameters& parameters);

/// One `a` for every input point: the option of the point where it is given, else `global`. `problem` is one
/// line when an option lies outside the range of `spec`, else empty.
struct Sharpness {
  std::vector<double> values;
  std::string problem;
};
[[nodiscard]] Sharpness sharpness_of(const Input& input, double global, const ParameterSpec& spec);

/// An `unsupported_input` fit that says why.
[[nodiscard]] Fit refusal(const Input& input, std::string why);

/// Fits a curve of the family to an input that passed the framework's checks; one `a` for every point. The
/// report's residual, counters and outcome are defined in this folder's README. Deterministic.
[[nodiscard]] Fit fit_family(const Input& input, SegmentKind kind, std::span<const double> a,
                             const Iteration& iteration);

}  // namespace kappabench::kappa
