#include "datasets/curves/given_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "schemes/api/find_nodes.hpp"
#include "schemes/api/soundness.hpp"
#include "schemes/curve/curve.hpp"
#include "schemes/segments/joint_claim.hpp"

namespace kappabench {

namespace {

Vec2 place_of(const Node& node, const std::vector<SegmentPtr>& segments) {
  return position_at(*segments[static_cast<std::size_t>(node.segment)], node.t);
}

/// Up to rounding of the coordinates.
bool ends_meet(const std::vector<SegmentPtr>& segments) {
  const Vec2 start = position_at(*segments.front(), 0.0), end = position_at(*segments.back(), 1.0);
  const double rounding = std::numeric_limits<double>::epsilon() * start.cwiseAbs().maxCoeff();
  return (end - start).norm() <= 8.0 * rounding;
}

std::vector<Node> vertices_of(const std::vector<SegmentPtr>& segments, bool closed) {
  std::vector<Node> nodes;
  const auto count = static_cast<int>(segments.size());
  nodes.reserve(segments.size() + 1);
  for (int i = 0; i < count; ++i) nodes.push_back({.point = i, .segment = i, .t = 0.0});
  if (!closed) nodes.push_back({.point = count, .segment = count - 1, .t = 1.0});
  return nodes;
}

/// Where the nodes are, by point; empty if a point has none.
std::vector<Vec2> points_of(const std::vector<Node>& nodes, const std::vector<SegmentPtr>& segments) {
  const auto last = std::ranges::max_element(nodes, {}, &Node::point);
  if (last == nodes.end() || last->point >= std::ssize(nodes)) return {};
  std::vector<std::optional<Vec2>> found(static_cast<std::size_t>(last->point) + 1);
  for (const Node& node : nodes)
    if (std::optional<Vec2>& point = found[static_cast<std::size_t>(node.point)]; !point)
      point = place_of(node, segments);
  std::vector<Vec2> points;
  points.reserve(found.size());
  for (const std::optional<Vec2>& point : found) {
    if (!point) return {};
    points.push_back(*point);
  }
  return points;
}

/// Throws std::invalid_argument for nodes and joints that no curve can have.
GivenCurve given(CurveRecord record) {
  GivenCurve curve;
  curve.own.closed = record.closed.value_or(ends_meet(record.segments));
  if (record.nodes) curve.own_nodes = *record.nodes;
  curve.own.points = points_of(curve.own_nodes, record.segments);
  if (curve.own.points.empty()) {
    curve.own_nodes = vertices_of(record.segments, curve.own.closed);
    curve.own.points = points_of(curve.own_nodes, record.segments);
  }
  const std::vector<Joint> joints = record.joints ? *record.joints : std::vector<Joint>{};
  const std::vector<Node>& nodes = record.nodes ? *record.nodes : curve.own_nodes;
  static_cast<void>(Curve(record.segments, joints, nodes, curve.own.closed));
  curve.record = std::move(record);
  return curve;
}

std::vector<Joint> found_joints(const std::vector<SegmentPtr>& segments, bool closed) {
  std::vector<Joint> joints;
  joints.reserve(segments.size());
  for (std::size_t i = 0; i + (closed ? 0 : 1) < segments.size(); ++i)
    joints.push_back(
        {static_cast<int>(i), claim_found(*segments[i], *segments[(i + 1) % segments.size()], Continuity::g2)});
  return joints;
}

Curve with_nodes(const CurveRecord& record, bool closed, std::vector<Node> nodes) {
  std::vector<Joint> joints = record.joints ? *record.joints : found_joints(record.segments, closed);
  return {record.segments, std::move(joints), std::move(nodes), closed};
}

/// Does the curve pass the nodes one after the other, once around if it is closed?
bool follow_one_another(const std::vector<Node>& nodes, bool closed) {
  int steps_back = 0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < nodes.size(); ++i) {
    const Node &node = nodes[i], &next = nodes[(i + 1) % nodes.size()];
    if (next.segment + next.t <= node.segment + node.t) ++steps_back;
  }
  return steps_back == (closed ? 1 : 0);
}

/// Along the points if the curve can be followed so, else against them if it can.
std::vector<Node> nodes_at(const std::vector<SegmentPtr>& segments, bool closed, const std::vector<Vec2>& points) {
  std::vector<Node> along = find_nodes(segments, closed, points);
  if (follow_one_another(along, closed)) return along;
  const std::vector<Vec2> reversed(points.rbegin(), points.rend());
  std::vector<Node> against = find_nodes(segments, closed, reversed);
  if (!follow_one_another(against, closed)) return along;
  std::ranges::reverse(against);
  for (std::size_t i = 0; i < against.size(); ++i) against[i].point = static_cast<int>(i);
  return against;
}

/// A curve with nodes at points that it may miss.
struct Projected {
  const GivenCurve* given;
  bool closed;
  std::vector<Node> nodes;
  double distance;  ///< the largest of a point
};

Projected projected(const GivenCurve& given, const Input& input) {
  const std::vector<SegmentPtr>& segments = given.record.segments;
  const bool closed = given.record.closed.value_or(input.closed && ends_meet(segments));
  Projected found{&given, closed, nodes_at(segments, closed, input.points), 0.0};
  if (found.nodes.empty()) found.distance = std::numeric_limits<double>::infinity();
  for (const Node& node : found.nodes)
    found.distance = std::max(found.distance,
                              (place_of(node, segments) - input.points[static_cast<std::size_t>(node.point)]).norm());
  return found;
}

bool same(const Input& a, const Input& b) { return a.closed == b.closed && a.points == b.points; }

SchemeInfo info_of(std::string id, const CurveFile& file) {
  SchemeInfo info{.id = std::move(id), .title = "curves of a file", .citation = "made elsewhere"};
  info.traits = {.fewest_open_points = 1,
                 .fewest_closed_points = 1,
                 .continuity = Continuity::g0,
                 .similarity_invariant = false,
                 .repeats_allowed = true};
  info.plugin = file.file.string();
  info.plugin_digest = file.digest;
  return info;
}

}  // namespace

GivenCurves::GivenCurves(std::string id, CurveFile file) : Scheme(info_of(std::move(id), file), Parameters({}, {})) {
  for (std::size_t i = 0; i < file.curves.size(); ++i) {
    if (file.curves[i].segments.empty()) continue;
    try {
      curves_.push_back(given(std::move(file.curves[i])));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: curve {}: {}", file.file.string(), i, error.what()));
    }
  }
}

Fit GivenCurves::solve(const Input& input) const {
  if (curves_.empty())
    return {.input = input,
            .curve = std::nullopt,
            .report = {.outcome = Outcome::failed, .message = "the file has no curve with segments"}};
  for (const GivenCurve& curve : curves_)
    if (same(curve.own, input))
      return {input, with_nodes(curve.record, input.closed, curve.own_nodes), curve.record.report};
  for (const GivenCurve& curve : curves_) {
    if (!curve.record.nodes || curve.record.closed.value_or(input.closed) != input.closed) continue;
    Curve as_fitted = with_nodes(curve.record, input.closed, *curve.record.nodes);
    if (unsoundness(as_fitted, input).empty()) return {input, std::move(as_fitted), curve.record.report};
  }
  std::vector<Projected> all;
  all.reserve(curves_.size());
  for (const GivenCurve& curve : curves_) all.push_back(projected(curve, input));
  Projected& nearest = *std::ranges::min_element(all, {}, &Projected::distance);
  Report report = nearest.given->record.report;
  if (const double chord = mean_chord(input); chord > 0.0) report.residual = nearest.distance / chord;
  return {input, with_nodes(nearest.given->record, nearest.closed, std::move(nearest.nodes)), std::move(report)};
}

Fit GivenCurves::resolve(const Fit& fit, const Edit& edit) const {
  return {.input = apply(fit.input, edit),
          .curve = std::nullopt,
          .report = {.outcome = Outcome::failed, .message = "a given curve is not fitted again"}};
}

}  // namespace kappabench
