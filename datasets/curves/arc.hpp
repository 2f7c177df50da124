#pragma once

#include "datasets/curves/transform.hpp"
#include "schemes/curve/segment.hpp"

namespace kappabench {

/// The numbers of SVG's arc command.
struct ArcArguments {
  Vec2 radii;
  double rotation;  ///< of the ellipse, degrees
  bool large, sweep;
};

/// The arc from one point to another, mapped; by SVG's rules (SVG 2, 9.5.1) radii that are too small grow until it
/// fits, and without a radius it is a line. So it is where it bends by less than 1e-8 of its chord. The points must
/// differ.
[[nodiscard]] SegmentPtr arc_between(const Vec2& from, const ArcArguments& arc, const Vec2& to, const AffineMap& map);

}  // namespace kappabench
