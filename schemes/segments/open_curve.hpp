#pragma once

#include <span>
#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// What schemes with one segment for each inner point of an open curve share.

/// Puts the nodes of the first and the last of `points` points round those of the others.
void add_end_nodes(std::vector<Node>& nodes, int points, int segments);

/// Whether all points lie on one line to rounding (1e-13 of their extent), and, if the curve is open, whether they
/// follow each other on it.
struct Line {
  bool straight, in_order;
};

[[nodiscard]] Line line_of(std::span<const Vec2> points, bool closed);

/// The line through points that are straight and in order: segments of degree 1 that meet halfway between inner points,
/// and one segment between two points. At least 2 points.
[[nodiscard]] Curve straight_line(std::span<const Vec2> points);

}  // namespace kappabench
