#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// A curve from p0 through p1 to p2 as two segments that meet at p1 smoothly up to the speed: with the parameter of the
/// whole curve running over lengths `first_extent` and `second_extent`, it is infinitely smooth.
struct ArcPair {
  SegmentPtr first, second;
  double first_extent, second_extent;
};

/// The legs turn straight back, the sine of the angle between them being at most `sine`: no circle or ellipse goes
/// through p0, p1, p2 in this order.
[[nodiscard]] bool folds_back(const Vec2& p0, const Vec2& p1, const Vec2& p2, double sine = 1e-9);

/// The circular arc p0, p1, p2; the straight line if the points are on one. They must not coincide or fold back.
/// Nothing is divided by their area: nearly straight triples lose no accuracy. Where the legs nearly fold back the
/// circle is as large as their angle is small, and its points have that many digits less.
[[nodiscard]] ArcPair circle_through(const Vec2& p0, const Vec2& p1, const Vec2& p2);

/// The elliptical arc whose one half axis ends at p1, and the other one at the neighbour that is farther from p1
/// (Yuksel 2020). The straight line if the angle between the legs is below 1e-9. Same conditions.
[[nodiscard]] ArcPair ellipse_through(const Vec2& p0, const Vec2& p1, const Vec2& p2);

/// The circle, or the ellipse where one of the circle's two halves turns by more than 90 degrees (Yuksel 2020).
[[nodiscard]] ArcPair circle_or_ellipse_through(const Vec2& p0, const Vec2& p1, const Vec2& p2);

}  // namespace kappabench
