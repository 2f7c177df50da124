#include "schemes/api/soundness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "schemes/curve/joint.hpp"

namespace kappabench {

namespace {

/// How exactly a drawing is known: lengths.
struct Resolution {
  double chord;  ///< mean
  double rounding;
};

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

/// The control points of a segment, if it has any: asked for once, for a curve may have a million segments.
using Hull = std::span<const Vec2>;

/// The ends of what is no Bézier segment are left to the joints and nodes.
bool finite_inside(const Segment& segment, const Hull& hull) {
  if (!hull.empty()) {
    Vec2 zero = Vec2::Zero();  // x - x is not 0 but for finite x
    for (const Vec2& p : hull) zero += p - p;
    return zero == Vec2::Zero();
  }
  const Jet jet = segment.jet(0.5, 2);
  return jet.d[0].allFinite() && jet.d[1].allFinite() && jet.d[2].allFinite();
}

std::string unmet_point(const Curve& curve, const Input& input, const Resolution& resolution) {
  std::vector<char> has_node(input.points.size(), 0);
  for (const Node& node : curve.nodes()) {
    if (node.point < 0 || node.point >= input.size())
      return fmt::format("a node names point {}; the points are 0 to {}", node.point, input.size() - 1);
    const auto point = static_cast<std::size_t>(node.point);
    has_node[point] = 1;
    const Vec2 at = position_at(curve.segment(node.segment), node.t);
    if (at == input.points[point]) continue;
    const double gap = (at - input.points[point]).norm();
    const double allowed = solver_accuracy * resolution.chord +
                           4.0 * std::max(resolution.rounding, std::numeric_limits<double>::epsilon() * at.norm());
    if (!(gap <= allowed))
      return fmt::format("the curve passes point {} at {:.3g} mean chords ({:.3g} explained by rounding)", node.point,
                         gap / resolution.chord, allowed / resolution.chord);
  }
  const auto without = std::ranges::find(has_node, 0);
  if (without == has_node.end()) return {};
  return fmt::format("the curve has no node at point {}", without - has_node.begin());
}

}  // namespace

std::string unsoundness(const Curve& curve, const Input& input) {
  if (curve.closed() != input.closed)
    return fmt::format("the curve is {}, the input {}", curve.closed() ? "closed" : "open",
                       input.closed ? "closed" : "open");
  const Resolution resolution{mean_chord(input), rounding_of(input)};
  std::vector<Hull> hulls;
  hulls.reserve(curve.segments().size());
  for (const SegmentPtr& segment : curve.segments()) hulls.push_back(segment->bezier_points());
  for (std::size_t i = 0; i < hulls.size(); ++i)
    if (!finite_inside(*curve.segments()[i], hulls[i])) return fmt::format("segment {} is not finite", i);
  if (std::string point = unmet_point(curve, input, resolution); !point.empty()) return point;
  for (const Joint& joint : curve.joints()) {
    const int next = curve.next(joint.segment);
    if (plainly_keeps(hulls[static_cast<std::size_t>(joint.segment)], hulls[static_cast<std::size_t>(next)],
                      joint.claimed, resolution.chord))
      continue;
    const JointSides sides = sides_of(curve.segment(joint.segment), curve.segment(next), resolution.rounding);
    if (const auto miss = miss_of(sides, joint.claimed, resolution.chord))
      return missed(curve, joint, *miss, resolution);
  }
  return {};
}

}  // namespace kappabench
