#pragma once

#include <span>
#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// One node for each point: where the curve passes nearest to it, in the order of the curve, so that a curve that
/// crosses itself at a point keeps its passages apart. The first point of an open curve is sought from its start on, of
/// a closed one anywhere. A place within rounding of a joint is the joint: the start of the segment after it.
[[nodiscard]] std::vector<Node> find_nodes(std::span<const SegmentPtr> segments, bool closed,
                                           std::span<const Vec2> points);

}  // namespace kappabench
