#pragma once

#include <Eigen/Core>

namespace kappabench {

/// A point or a vector of the plane, in the units of the input drawing.
using Vec2 = Eigen::Vector2d;

/// The z component of the cross product, twice the signed area of the triangle (0, a, b);
/// positive when b lies to the left of a.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// `a` turned by +90 degrees.
[[nodiscard]] inline Vec2 left_normal(const Vec2& a) { return {-a.y(), a.x()}; }

}  // namespace kappabench
