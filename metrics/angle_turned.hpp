#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// Integral of |kappa| ds over a segment, cusps not included, in radians: the sum, over the pieces between inflections
/// and cusps, of the angle that the tangent turns through. `length` is that of the segment.
///
/// No quadrature where the speed varies: the angle is added up from the directions at the ends of steady stretches,
/// between which it is less than 60 degrees, so it is as good near a cusp as elsewhere. A cusp is where the speed falls
/// below 1e-8 of its mean, at an end of the segment, too; the direction there is the limit from either side. Clothoids
/// and curvature as a B-spline: the integral of a polynomial between knots, exact by Gauss-Kronrod rule.
[[nodiscard]] double angle_turned(const Segment& segment, double length);

}  // namespace kappabench
