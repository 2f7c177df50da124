#include "schemes/api/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "schemes/curve/joint.hpp"

namespace kappabench {

namespace {

/// A point may be missed by this part of the mean chord beyond rounding: 4096 roundings, as joints.
constexpr double solved = 0x1p-40;

std::string missed(const Curve& curve, const Joint& joint, const JointMiss& miss, const Resolution& resolution) {
  const auto said = [&](std::string_view what, double unit, std::string_view of_unit) {
    return fmt::format("the joint of segments {} and {} claims {}, but {} {:.3g}{} ({:.3g} explained by rounding)",
                       joint.segment, curve.next(joint.segment), name(joint.claimed), what, miss.measured / unit,
                       of_unit, miss.allowed / unit);
  };
  switch (miss.of) {
    case JointMiss::Of::position:
      return said("its sides are apart by", resolution.chord, " mean chords");
    case JointMiss::Of::tangent:
      return said(fmt::format("the direction turns from {:.9g} to {:.9g} rad, by", miss.before, miss.after), 1.0, "");
    case JointMiss::Of::curvature:
      return said(fmt::format("the curvature times the mean chord jumps from {:.9g} to {:.9g}, by",
                              miss.before * resolution.chord, miss.after * resolution.chord),
                  1.0 / resolution.chord, "");
    case JointMiss::Of::first_derivative:
      return said("the first derivative jumps by", resolution.chord, " mean chords");
    case JointMiss::Of::second_derivative:
      return said("the second derivative jumps by", resolution.chord, " mean chords");
  }
  return {};
}

/// Where the segment is not finite: its ends, which the joints and nodes look at, are left to them.
bool finite_inside(const Segment& segment) {
  const std::span<const Vec2> points = segment.bezier_points();
  if (!points.empty()) return std::ranges::all_of(points, [](const Vec2& p) { return p.allFinite(); });
  const Jet jet = segment.jet(0.5, 2);
  return jet.d[0].allFinite() && jet.d[1].allFinite() && jet.d[2].allFinite();
}

Vec2 position_at(const Segment& segment, double t) {
  if (const std::span<const Vec2> points = segment.bezier_points(); !points.empty()) {
    if (t == 0.0) return points.front();
    if (t == 1.0) return points.back();
  }
  return segment.jet(t, 0).position();
}

std::string unmet_point(const Curve& curve, const Input& input, const Resolution& resolution) {
  std::vector<bool> has_node(input.points.size(), false);
  for (const Node& node : curve.nodes()) {
    if (node.point < 0 || node.point >= input.size())
      return fmt::format("a node names point {}; the points are 0 to {}", node.point, input.size() - 1);
    const auto point = static_cast<std::size_t>(node.point);
    const Vec2 at = position_at(curve.segment(node.segment), node.t);
    const double gap = (at - input.points[point]).norm();
    const double allowed = solved * resolution.chord +
                           4.0 * std::max(resolution.rounding, std::numeric_limits<double>::epsilon() * at.norm());
    if (!(gap <= allowed))
      return fmt::format("the curve passes point {} at {:.3g} mean chords ({:.3g} explained by rounding)", node.point,
                         gap / resolution.chord, allowed / resolution.chord);
    has_node[point] = true;
  }
  const auto without = std::ranges::find(has_node, false);
  if (without == has_node.end()) return {};
  return fmt::format("the curve has no node at point {}", without - has_node.begin());
}

}  // namespace

Resolution resolution_of(const Input& input) {
  double largest = 0.0;
  for (const Vec2& p : input.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return {mean_chord(input), std::numeric_limits<double>::epsilon() * largest};
}

std::string unsoundness(const Curve& curve, const Input& input, const Resolution& resolution) {
  if (curve.closed() != input.closed)
    return fmt::format("the curve is {}, the input {}", curve.closed() ? "closed" : "open",
                       input.closed ? "closed" : "open");
  for (int i = 0; i < curve.size(); ++i)
    if (!finite_inside(curve.segment(i))) return fmt::format("segment {} is not finite", i);
  if (std::string point = unmet_point(curve, input, resolution); !point.empty()) return point;
  for (const Joint& joint : curve.joints())
    if (const auto miss = miss_of(sides_of(curve, joint, resolution.rounding), joint.claimed, resolution.chord))
      return missed(curve, joint, *miss, resolution);
  return {};
}

}  // namespace kappabench
