#pragma once

#include <utility>
#include <vector>

#include "schemes/api/fit.hpp"

namespace kappabench::wang {

/// What Wang et al. 2024 mark by hand in Fig. 14, found in any curve. What counts is what an eye could see.

inline constexpr double visible_jump = 1e-3;      ///< of curvature at a joint, relative (metrics/continuity.hpp)
inline constexpr double visible_offset = 0.05;    ///< arc length to an extremum over the local chord
inline constexpr double visible_reversal = 0.01;  ///< of curvature, over its range on the curve

struct VisibleFlaws {
  int joints = 0;
  std::vector<Vec2> jumps;        ///< joints where curvature jumps
  int jumps_at_sign_changes = 0;  ///< of these, where its sign changes too
  int points = 0;                 ///< nodes that are not the ends of an open curve
  std::vector<Vec2> off_extrema;  ///< of these, away from every extremum of curvature
  int points_off_peaks = 0;       ///< away from every local maximum of |curvature|
  int pieces = 0;                 ///< from midpoint to midpoint around a node
  /// Arc lengths of the pieces with more than two intervals of monotone curvature, the start first.
  std::vector<std::pair<double, double>> many_intervals;
  int alternating_spans = 0;         ///< between nodes with curvature of opposite signs
  int alternating_not_monotone = 0;  ///< of these, with an extremum inside
};

/// `fit` has a curve.
[[nodiscard]] VisibleFlaws visible_flaws(const Fit& fit);

}  // namespace kappabench::wang
