#include "schemes/kappa/assemble.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "schemes/kappa/marks.hpp"
#include "schemes/segments/joint_claim.hpp"
#include "schemes/segments/open_curve.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"

namespace kappabench::kappa {
namespace {

/// A segment whose joints are both this near to its point, over the point's size, has shrunk to the point, whatever
/// made it so small.
constexpr double shrunk = 1e-11;

SegmentPtr make_segment(SegmentKind kind, double a, const Vec2& c0, const Vec2& c1, const Vec2& c2) {
  switch (kind) {
    case SegmentKind::quadratic:
      return std::make_shared<const PolynomialSegment>(std::array{c0, c1, c2});
    case SegmentKind::cubic:  // Miura 2022, Eq. (1)
      return std::make_shared<const PolynomialSegment>(
          std::array<Vec2, 4>{c0, (1.0 - a) * c0 + a * c1, a * c1 + (1.0 - a) * c2, c2});
    case SegmentKind::trigonometric:
      break;
  }
  return std::make_shared<const TrigonometricSegment>(  // Eq. (17)
      std::array<Vec2, 5>{c0, (1.0 - a) * c0 + a * c1, 0.5 * ((1.0 - a) * (c0 + c2) + 2.0 * a * c1),
                          a * c1 + (1.0 - a) * c2, c2});
}

/// One segment that is really there.
struct Piece {
  std::size_t number;  ///< in the chain
  int sign;            ///< of its curvature, 0 if none
  bool straight;       ///< to the resolution of areas
};

/// Whether |kappa| has a minimum where the segment passes its point, judged by its slope on both sides.
bool at_minimum(const ChordChain& chain, std::size_t i, const Vec2& e, const Ends& q, double t) {
  const double step = 1e-4 * last_parameter(chain.basis);
  return peak_slope(chain, i, e, q, t - step) < 0.0 && peak_slope(chain, i, e, q, t + step) > 0.0;
}

/// The parameter beside t where the segment is nearest to its point, to first order. Where curvature is nearly
/// constant, as along straight runs, rounding moves its peak farther than the place where the curve passes the point.
double nearest(const Segment& segment, double t, const Vec2& point) {
  const Jet jet = segment.jet(t, 1);
  const double squared = jet.d[1].squaredNorm(), along = (point - jet.position()).dot(jet.d[1]);
  return squared > 0.0 ? std::clamp(t + along / squared, 0.0, 1.0) : t;
}

}  // namespace

Assembled assemble(const Input& input, SegmentKind kind, const ChordChain& chain, const State& state,
                   const Setting& setting) {
  const std::size_t m = chain.segments();
  const Ratios ratios = ratios_of(state);
  const int first_point = input.closed ? 0 : 1;
  const auto point_of = [&](std::size_t i) { return static_cast<int>(i) - 1 + first_point; };
  const auto position = [&](std::size_t i) { return input.points[static_cast<std::size_t>(point_of(i))]; };

  std::vector<Ends> q(m + 1);
  std::vector<Piece> pieces;
  std::vector<bool> gone(m + 2, false);
  for (std::size_t i = 1; i <= m; ++i) {
    q[i] = ends(chain, state, ratios, i);
    gone[i] = setting.form[i] == Form::shrunk ||
              (m > 1 && q[i].x.norm() < shrunk * chain.size[i] && q[i].y.norm() < shrunk * chain.size[i]);
    const PolygonLegs legs = polygon_legs(chain, state, i);
    const double turn = cross(legs.before, legs.after);
    if (!gone[i]) pieces.push_back({i, turn > 0.0 ? 1 : turn < 0.0 ? -1 : 0, is_straight(chain, legs, i)});
  }
  // Each joint once, so that its two segments meet exactly; a shrunken segment gives its point to both.
  std::vector<Vec2> joint(m + 1);
  for (std::size_t k = 1; k <= m; ++k) {
    const std::size_t next = chain.next(k);
    joint[k] = gone[k] ? position(k) : (next <= m && gone[next]) ? position(next) : Vec2(position(k) + q[k].y);
  }
  joint[0] = input.closed ? joint[m] : input.points.front();
  if (!input.closed) joint[m] = input.points.back();

  std::map<std::string, long> counters{{"s_joints", 0}};
  for (const MarkSpec& mark : marks::of(kind)) counters[mark.name] = 0;
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  const double last = last_parameter(chain.basis);
  for (std::size_t i = 1; i <= m; ++i) {
    const Form form = setting.form[i];
    if (gone[i]) {
      // The node is the end of the segment before; of a closed curve's very first one, the start of what follows.
      const int before = static_cast<int>(segments.size()) - 1;
      nodes.push_back({.point = point_of(i),
                       .segment = std::max(before, 0),
                       .t = before < 0 ? 0.0 : 1.0,
                       .marks = {std::string(marks::at_inflection)}});
      continue;
    }
    const bool pinned = is_pinned(form);
    const double t = form == Form::at_start ? 0.0 : form == Form::at_end ? last : stationary_parameter(chain, i, q[i]);
    Node node{.point = point_of(i), .segment = static_cast<int>(segments.size()), .t = t / last};
    if (pinned) node.marks.emplace_back(marks::pinned);
    if (kind == SegmentKind::trigonometric && !pinned && at_minimum(chain, i, state.e[i], q[i], t))
      node.marks.emplace_back(marks::curvature_minimum);
    segments.push_back(make_segment(kind, chain.a[i], joint[i - 1], position(i) + state.e[i], joint[i]));
    if (!pinned) node.t = nearest(*segments.back(), node.t, position(i));
    nodes.push_back(std::move(node));
  }
  for (const Node& node : nodes)
    for (const std::string& mark : node.marks) ++counters[mark];
  const std::size_t count = pieces.size(), met = input.closed ? count : count - 1;
  for (std::size_t k = 0; k < met; ++k) {
    const std::size_t after = (k + 1) % count;
    const bool s_shaped = pieces[k].sign * pieces[after].sign < 0;
    counters["s_joints"] += s_shaped;
    const Continuity smooth = s_shaped ? Continuity::g1_equal_magnitude : Continuity::g2;
    // A segment that shrank in between may have turned from one direction and curvature to others; curvatures of what
    // is straight to rounding are not matched.
    const bool matched =
        chain.next(pieces[k].number) == pieces[after].number && !pieces[k].straight && !pieces[after].straight;
    joints.push_back({static_cast<int>(k), matched ? claim_at(*segments[k], *segments[after], smooth)
                                                   : claim_found(*segments[k], *segments[after], smooth)});
  }
  if (!input.closed) add_end_nodes(nodes, input.size(), static_cast<int>(segments.size()));
  return {Curve(std::move(segments), std::move(joints), std::move(nodes), input.closed), std::move(counters)};
}

}  // namespace kappabench::kappa
