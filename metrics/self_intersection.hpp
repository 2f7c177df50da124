#pragma once

#include <vector>

#include "metrics/arc_map.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// A point that the curve passes twice, transversally.
struct Crossing {
  CurvePlace first;
  CurvePlace second;
  Vec2 position;
};

struct Crossings {
  std::vector<Crossing> found;
  bool complete;  ///< false: two stretches coincide or nearly so, and the search was given up
};

/// All transversal self-intersections of a curve.
///
/// Method: the curve is cut at joints, inflections and cusps, and further until no arc turns by more than 60
/// degrees. Such an arc is convex and lies in the triangle of its chord and its end tangents; two neighbours that turn
/// by less than 180 degrees together, the corner between them included, meet only at their common end. The other pairs
/// are compared by separating axes of their triangles and bisected until they are apart, or until their tangent
/// directions differ throughout, so that they meet at most once, and Newton's method has found the crossing inside
/// both. Contacts without crossing and pairs of crossings closer than 1e-9 of the curve's length are not reported. The
/// triangles enclose the arcs as far as the inflections are certified; on blends and opaque segments they are sampled.
[[nodiscard]] Crossings self_intersections(const Curve& curve);

}  // namespace kappabench
