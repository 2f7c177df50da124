#pragma once

namespace kappabench::clothoid3 {

/// The limits and finite differences of a fit.
struct Rules {
  /// The constants of the public implementation, in the units of the drawing, its forward differences and its 16
  /// bisections, instead of limits relative to the mean chord, derivatives and solved equations.
  bool compat;
  bool g1_curvature;       ///< curvature at a point from the clothoids to its neighbours, not from the local conic
  double aligned_sine;     ///< legs whose directions differ by less have no turning
  double least_curvature;  ///< a span with less at an end is not refined; slack of the refined property
  double least_length;     ///< a clothoid shorter than that is left out (pieces=clc)
  double corner_distance;  ///< consecutive points closer than that make a corner; 0: none do
};

/// `chord` is the mean chord of the input.
[[nodiscard]] inline Rules relative_rules(double chord, bool g1_curvature) {
  return {.compat = false,
          .g1_curvature = g1_curvature,
          .aligned_sine = 1e-9,
          .least_curvature = 1e-6 / chord,
          .least_length = 1e-9 * chord,
          .corner_distance = 0.0};
}

[[nodiscard]] inline Rules published_rules(bool g1_curvature) {
  return {.compat = true,
          .g1_curvature = g1_curvature,
          .aligned_sine = 1e-3,
          .least_curvature = 1e-6,
          .least_length = 1e-6,
          .corner_distance = 1e-2};
}

}  // namespace kappabench::clothoid3
