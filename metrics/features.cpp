#include "metrics/features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/node_pieces.hpp"
#include "metrics/self_intersection.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/curve/tangents.hpp"

namespace kappabench {
namespace {

constexpr double at_place = 1e-6;  // of the mean chord
constexpr double rounding = 1e-9;  // of the length
constexpr double reversal = 1e-6;  // rad short of pi

int sign_of(double v) { return v > 0.0 ? 1 : v < 0.0 ? -1 : 0; }

/// Changes closer than rounding to each other: an odd number is one change, an even number none.
std::vector<double> cancel_pairs(std::vector<double> positions, double close) {
  std::sort(positions.begin(), positions.end());
  std::vector<double> kept;
  for (std::size_t i = 0; i < positions.size();) {
    std::size_t j = i + 1;
    while (j < positions.size() && positions[j] - positions[j - 1] <= close) ++j;
    if ((j - i) % 2 == 1) kept.push_back(positions[i + (j - i) / 2]);
    i = j;
  }
  return kept;
}

/// How many of some places are at a node, and how many of the others at a joint.
struct Whereabouts {
  double all = 0.0;
  double at_nodes = 0.0;
  double at_joints = 0.0;
};

class Landmarks {
 public:
  Landmarks(const Curve& curve, const ArcMap& arcs, double chord)
      : length_(arcs.length()), closed_(curve.closed()), close_(at_place * chord) {
    for (const PlacedNode& node : nodes_in_order(curve, arcs)) nodes_.push_back(node.position);
    for (const Joint& joint : curve.joints()) joints_.push_back(arcs.position({joint.segment, 1.0}));
  }

  /// Each place is one or two arc lengths (a crossing is passed twice).
  void count(const std::vector<double>& place, Whereabouts& where) const {
    const auto any_near = [&](const std::vector<double>& marks) {
      return std::any_of(place.begin(), place.end(), [&](double s) {
        return std::any_of(marks.begin(), marks.end(), [&](double mark) { return near(s, mark); });
      });
    };
    where.all += 1.0;
    if (any_near(nodes_)) {
      where.at_nodes += 1.0;
    } else if (any_near(joints_)) {
      where.at_joints += 1.0;
    }
  }

 private:
  [[nodiscard]] bool near(double a, double b) const {
    const double direct = std::abs(a - b);
    return (closed_ ? std::min(direct, length_ - direct) : direct) <= close_;
  }

  double length_;
  bool closed_;
  double close_;
  std::vector<double> nodes_;
  std::vector<double> joints_;
};

bool certified_inflections(const Curve& curve) {
  return std::ranges::all_of(curve.segments(), [](const SegmentPtr& s) { return inflections(*s).certified; });
}

}  // namespace

std::vector<double> inflection_positions(const Curve& curve, const ArcMap& arcs) {
  std::vector<double> positions;
  int first = 0;   // sign of the curvature where it is first not zero
  int before = 0;  // sign of the curvature so far
  for (int i = 0; i < curve.size(); ++i) {
    const SignChanges changes = inflections(curve.segment(i));
    if (changes.vanishes) continue;
    const double until = changes.at.empty() ? 1.0 : changes.at.front().lo;
    const int start = sign_of(curvature(curve.segment(i).jet(0.5 * until, 2)));
    if (start == 0) continue;
    if (before != 0 && start != before) positions.push_back(arcs.position({i, 0.0}));
    for (const RootBracket& bracket : changes.at) positions.push_back(arcs.position({i, bracket.mid()}));
    before = changes.at.size() % 2 == 0 ? start : -start;
    if (first == 0) first = start;
  }
  if (curve.closed() && before != first) positions.push_back(arcs.length());
  const double close = rounding * arcs.length();
  for (double& s : positions) {  // both sides of the closure are one place
    if (curve.closed() && s >= arcs.length() - close) s -= arcs.length();
  }
  std::vector<double> kept = cancel_pairs(positions, close);
  for (double& s : kept) s = std::max(0.0, s);
  return kept;
}

std::vector<double> cusp_positions(const Curve& curve, const ArcMap& arcs) {
  std::vector<double> positions;
  for (int i = 0; i < curve.size(); ++i) {
    for (const double t : cusps(curve.segment(i))) positions.push_back(arcs.position({i, t}));
  }
  for (const Joint& joint : curve.joints()) {
    const int next = curve.next(joint.segment);
    const auto tangent = [&](int segment, double t, Side side) {
      return unit_tangent(curve.segment(segment), t, side, 1e-8 * arcs.segment_length(segment));
    };
    const double angle = angle_between(tangent(joint.segment, 1.0, Side::before), tangent(next, 0.0, Side::after));
    if (std::abs(angle) > std::numbers::pi - reversal) positions.push_back(arcs.position({joint.segment, 1.0}));
  }
  std::sort(positions.begin(), positions.end());
  return positions;
}

Metric features_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const ArcMap arcs(curve);
    const Landmarks landmarks(curve, arcs, mean_chord(fit.input));
    Whereabouts inflection;
    for (const double s : inflection_positions(curve, arcs)) landmarks.count({s}, inflection);
    Whereabouts cusp;
    for (const double s : cusp_positions(curve, arcs)) landmarks.count({s}, cusp);
    Whereabouts loop;
    const Crossings crossings = self_intersections(curve);
    for (const Crossing& c : crossings.found) landmarks.count({arcs.position(c.first), arcs.position(c.second)}, loop);
    if (!crossings.complete) loop = {undefined, undefined, undefined};

    // Only the sign changes are certified: nearness is arc length by quadrature, a cusp is slow against a mean speed of
    // samples, and the search for crossings carries no bound of its rounding.
    using enum Method;
    return std::vector<Measurement>{column::inflections(inflection.all, certified_inflections(curve) ? exact : sampled),
                                    column::inflections_at_nodes(inflection.at_nodes, sampled),
                                    column::inflections_at_joints(inflection.at_joints, sampled),
                                    column::cusps(cusp.all, sampled),
                                    column::cusps_at_nodes(cusp.at_nodes, sampled),
                                    column::cusps_at_joints(cusp.at_joints, sampled),
                                    column::loops(loop.all, sampled),
                                    column::loops_at_nodes(loop.at_nodes, sampled),
                                    column::loops_at_joints(loop.at_joints, sampled)};
  };
  return {.id = "features",
          .title = "Inflections, cusps and loops",
          .version = 2,
          .columns = {column::inflections, column::inflections_at_nodes, column::inflections_at_joints, column::cusps,
                      column::cusps_at_nodes, column::cusps_at_joints, column::loops, column::loops_at_nodes,
                      column::loops_at_joints},
          .measure = measure};
}

}  // namespace kappabench
