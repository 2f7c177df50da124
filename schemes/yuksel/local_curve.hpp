#pragma once

#include <optional>
#include <string_view>

#include "schemes/segments/three_point_arcs.hpp"

namespace kappabench::yuksel {

/// The curve through a point and its two neighbours that the spans beside the point blend (Yuksel 2020, Sect. 4).
enum class Arc {
  bezier,      ///< quadratic Bezier curve, |curvature| largest at the middle point
  circular,    ///< circle through the three points
  elliptical,  ///< ellipse with the middle point at the end of a half axis
  hybrid       ///< circle, ellipse where half of the circle turns by more than 90 degrees
};

/// `word` is one of bezier, circular, elliptical, hybrid; anything else throws std::logic_error.
[[nodiscard]] Arc arc_of(std::string_view word);

/// The local curve through p0, p1, p2. nullopt if there is none: the points fold back and `arc` is not bezier.
[[nodiscard]] std::optional<ArcPair> local_curve(Arc arc, const Vec2& p0, const Vec2& p1, const Vec2& p2);

/// The pair with the parameters of both halves sent through fractional linear maps that make its speed and acceleration
/// continuous at p1 for halves of equal parameter length.
[[nodiscard]] ArcPair with_equal_extents(const ArcPair& pair);

}  // namespace kappabench::yuksel
