#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// How far rounding of its coordinates can have moved a place of a segment, and its derivatives by t there: lengths.
struct RoundingError {
  double position, first, second;
};

/// `known_to`, a length: what the coordinates of the drawing are rounded to; coordinates of the curve that are larger
/// round by more. What is no Bézier segment is taken for a cubic.
[[nodiscard]] RoundingError rounding_error(const Segment& segment, const Vec2& position, double known_to);
[[nodiscard]] RoundingError rounding_error(int degree, const Vec2& position, double known_to);

/// The same of the curvature c' x c'' / |c'|^3. Infinite, or not a number, at rest.
[[nodiscard]] double curvature_error(const Vec2& first, const Vec2& second, const RoundingError& error);

}  // namespace kappabench
