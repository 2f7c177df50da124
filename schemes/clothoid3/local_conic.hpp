#pragma once

#include "schemes/clothoid3/rules.hpp"
#include "schemes/curve/vec.hpp"

namespace kappabench::clothoid3 {

/// Where on the conic through three points a heading is wanted: at the first, second or third of them.
enum class Place { start, middle, end };

/// What a curve has at a point.
struct G2Data {
  double heading;
  double curvature;
};

/// Heading and signed curvature of the local conic through p0, p1, p2: the circle, or where half of it turns by more
/// than 90 degrees the ellipse that has p1 at the end of one half axis and its farther neighbour at the end of the
/// other one. Derivatives; with the published rules differences of step 1e-3.
[[nodiscard]] G2Data local_conic(const Vec2& p0, const Vec2& p1, const Vec2& p2, Place place, const Rules& rules);

}  // namespace kappabench::clothoid3
