#pragma once

#include <vector>

#include "metrics/arc_map.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// A node with its arc length from the start of the curve.
struct PlacedNode {
  Node node;
  double position;
};

/// The nodes in the order in which the curve meets them. Nodes of one point closer than 1e-9 of the curve's length are
/// one (a point at a joint may be listed from both sides).
[[nodiscard]] std::vector<PlacedNode> nodes_in_order(const Curve& curve, const ArcMap& arcs);

/// A stretch of one segment, t0 < t1.
struct Part {
  int segment;
  double t0;
  double t1;
};

/// The stretches from arc length s0 to s1 >= s0; on a closed curve both may lie outside [0, length], at most one turn.
[[nodiscard]] std::vector<Part> parts_between(const Curve& curve, const ArcMap& arcs, double s0, double s1);

/// The piece that belongs to a node: from the arc-length midpoint before it to the one after it.
struct CentredPiece {
  PlacedNode node;
  double start;  ///< arc lengths; start < node.position < end, before any wrap-around
  double end;
  std::vector<Part> parts;
};

/// Is the node at an end of an open curve?
[[nodiscard]] bool at_end(const PlacedNode& node, const Curve& curve, const ArcMap& arcs);

/// One piece for each node. Nodes at the ends of an open curve have none, nor have nodes that coincide with a
/// neighbour. An end of an open curve that is no node (the scheme did not list it) stands in for the missing neighbour.
[[nodiscard]] std::vector<CentredPiece> centred_pieces(const Curve& curve, const ArcMap& arcs);

}  // namespace kappabench
