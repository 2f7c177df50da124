#pragma once

#include <span>
#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// One node of a quadrature over arc length: the integral of f over the piece is the sum of weight * f(sample).
struct ArcSample {
  double t;          ///< parameter in the segment
  double s;          ///< arc length from the start of the piece
  double weight;     ///< ds
  double curvature;  ///< signed
  double rate;       ///< d curvature / ds
};

/// Quadrature for smooth functions of arc length, curvature and its rate over a piece of a segment.
///
/// Method: 15-point Gauss-Kronrod panels, split at `splits` (curvature extrema, inflections) and then bisected, worst
/// first, until length, integral of kappa^2 and integral of (d kappa / ds)^2 have an estimated relative error below
/// 1e-13 (1e-11 for the last), or 200 panels are reached: at a cusp the latter two integrals diverge.
/// `s` within a panel is the integral of the polynomial through its 15 speeds.
/// Samples are ascending; those with infinite or undefined curvature (zero speed) are left out.
[[nodiscard]] std::vector<ArcSample> arc_samples(const Segment& segment, double t0, double t1,
                                                 std::span<const double> splits = {});

}  // namespace kappabench
