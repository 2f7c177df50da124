#include "metrics/node_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace kappabench {

std::vector<PlacedNode> nodes_in_order(const Curve& curve, const ArcMap& arcs) {
  const double length = arcs.length();
  const double same = 1e-9 * length;
  std::vector<PlacedNode> nodes;
  for (const Node& node : curve.nodes()) {
    double position = arcs.position({node.segment, node.t});
    if (curve.closed() && position >= length - 1e-14 * length) position = 0.0;
    nodes.push_back({node, position});
  }
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const PlacedNode& a, const PlacedNode& b) { return a.position < b.position; });
  const auto duplicate = [&](const PlacedNode& a, const PlacedNode& b) {
    return a.node.point == b.node.point && std::abs(b.position - a.position) <= same;
  };
  nodes.erase(std::unique(nodes.begin(), nodes.end(), duplicate), nodes.end());
  if (curve.closed() && nodes.size() > 1 && nodes.front().node.point == nodes.back().node.point &&
      nodes.front().position + length - nodes.back().position <= same) {
    nodes.pop_back();
  }
  return nodes;
}

std::vector<Part> parts_between(const Curve& curve, const ArcMap& arcs, double s0, double s1) {
  const CurvePlace from = arcs.place(s0);
  const CurvePlace to = arcs.place(s1);
  std::vector<Part> parts;
  const auto add = [&parts](int segment, double t0, double t1) {
    if (t0 < t1) parts.push_back({segment, t0, t1});
  };
  const bool short_of_a_turn =
      s1 - s0 <= arcs.segment_length(from.segment) && s1 - s0 < (1.0 - 1e-9) * arcs.length() && to.t >= from.t;
  if (to.segment == from.segment && (short_of_a_turn || !curve.closed())) {
    add(from.segment, from.t, to.t);
    return parts;
  }
  add(from.segment, from.t, 1.0);
  for (int i = curve.next(from.segment); i != to.segment; i = curve.next(i)) add(i, 0.0, 1.0);
  add(to.segment, 0.0, to.t);
  return parts;
}

bool at_end(const PlacedNode& node, const Curve& curve, const ArcMap& arcs) {
  const double close = 1e-9 * arcs.length();
  return !curve.closed() && (node.position <= close || node.position >= arcs.length() - close);
}

std::vector<CentredPiece> centred_pieces(const Curve& curve, const ArcMap& arcs) {
  const std::vector<PlacedNode> nodes = nodes_in_order(curve, arcs);
  const std::size_t n = nodes.size();
  std::vector<CentredPiece> pieces;
  for (std::size_t i = 0; i < n; ++i) {
    if (at_end(nodes[i], curve, arcs)) continue;
    const double here = nodes[i].position;
    const double length = arcs.length();
    const double before_first = curve.closed() ? nodes.back().position - length : 0.0;
    const double after_last = curve.closed() ? nodes.front().position + length : length;
    const double before = i == 0 ? before_first : nodes[i - 1].position;
    const double after = i + 1 == n ? after_last : nodes[i + 1].position;
    const double start = 0.5 * (before + here);
    const double end = 0.5 * (here + after);
    const double least = 1e-12 * arcs.length();
    if (!(here - start > least) || !(end - here > least)) continue;
    pieces.push_back({nodes[i], start, end, parts_between(curve, arcs, start, end)});
  }
  return pieces;
}

}  // namespace kappabench
