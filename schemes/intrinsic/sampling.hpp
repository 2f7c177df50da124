#pragma once

#include <vector>

#include "schemes/intrinsic/hermite_data.hpp"
#include "schemes/intrinsic/sine_cosine.hpp"

namespace kappabench::intrinsic {

/// `count` >= 2 points of a curve in standard form (start at the origin, chord along the x axis), equally spaced in arc
/// length, both ends included: what Yoshida 2022, Table 1 times with 500 of them.
///
/// One pass of the trapezium rule with its first correction between neighbouring points and knots: the curvature that
/// it needs is known, so one sine and cosine a point is all. With 500 points on a curve that turns by 3 rad the error
/// is about 1e-12 chords, and falls with the fourth power of the number; the segment's own jets are exact to rounding.
[[nodiscard]] std::vector<Vec2> sample_points(const StandardCurve& curve, double chord_angle, int count, Sines sines);

}  // namespace kappabench::intrinsic
