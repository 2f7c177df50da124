#pragma once

#include <vector>

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// Where to cut a segment so that quadrature over each stretch sees all there is: ascending parameters from 0 to 1.
/// Between two neighbours the velocity c' stays in a disc that has 0 at twice its radius from its centre or further:
/// the speed varies by less than a factor of 3, the direction by less than 60 degrees. However near to a cusp a segment
/// comes, it gets a stretch of that size there; at a cusp the stretches shrink by halves to 2^-48 of the segment.
///
/// Proved for polynomial and trigonometric segments: the disc holds the control vectors of the velocity on the stretch
/// (of a trigonometric segment, of (1 + tan^2(pi t / 4))^2 times the velocity, and that factor is between 1 and 4).
/// Of blends, elliptical arcs, reparametrised and opaque segments the disc is estimated, by the third-order Taylor
/// polynomial of c' in the middle of the stretch. Where the curvature is given over arc length, the speed is constant,
/// and the cuts are the knots alone: the direction may then turn by any angle.
[[nodiscard]] std::vector<double> steady_stretches(const Segment& segment);

/// True for clothoids and curvature as a B-spline: t is arc length over the length.
[[nodiscard]] bool has_constant_speed(const Segment& segment);

}  // namespace kappabench
