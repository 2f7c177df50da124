#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

enum class Side { before, after };

/// Unit tangent, in the direction of travel, as the limit from one side of t: the first derivative whose length
/// is not lost against `rest` (a length per unit of t below which the speed counts as zero) decides, so it is also
/// defined where the segment rests. Zero vector where all four derivatives vanish.
[[nodiscard]] Vec2 unit_tangent(const Segment& segment, double t, Side side, double rest);

/// Signed angle from a to b in (-pi, pi], radians; 0 if one of them is zero.
[[nodiscard]] double angle_between(const Vec2& a, const Vec2& b);

}  // namespace kappabench
