#pragma once

#include <span>
#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// One node for each point: where the curve passes nearest to it. Where it passes a point more than once, all about as
/// near, the order of the points decides: those passages are taken that follow one another, on a closed curve around
/// it. If none do, each point has its nearest one. A place within rounding of a joint is the joint: the start of the
/// segment after it, or the end of an open curve.
///
/// Distances are followed at 32 steps a segment, so that a segment is taken to pass a point once within two of them.
/// Segments are found by a tree of boxes: time grows with n log n. No nodes if the curve or a point is not finite.
[[nodiscard]] std::vector<Node> find_nodes(std::span<const SegmentPtr> segments, bool closed,
                                           std::span<const Vec2> points);

}  // namespace kappabench
