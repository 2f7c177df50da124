#include "metrics/features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/curvature_profile.hpp"
#include "metrics/node_pieces.hpp"
#include "metrics/self_intersection.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/curve/joint.hpp"
#include "schemes/curve/tangents.hpp"

namespace kappabench {
namespace {

constexpr double at_place = 1e-6;  // of the mean chord
constexpr double reversal = 1e-6;  // rad short of pi
constexpr int looks = 8;           // at a stretch of one sign, for a curvature that is more than rounding

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

/// A stretch of a segment on which the curvature has one sign.
struct Stretch {
  CurvePlace start;
  int sign;  ///< 0: it is no more than rounding
};

int sign_on(const Segment& segment, double t0, double t1, double known_to) {
  for (int i = 0; i < looks; ++i) {
    const Jet jet = segment.jet(t0 + (t1 - t0) * (i + 0.5) / looks, 2);
    const double kappa = curvature(jet);
    const RoundingError error = rounding_error(segment, jet.position(), known_to);
    if (std::abs(kappa) > curvature_error(jet.d[1], jet.d[2], error)) return kappa > 0.0 ? 1 : -1;
  }
  return 0;
}

}  // namespace

Features find_inflections(const Curve& curve, const ArcMap& arcs, double known_to) {
  Features result;
  std::vector<Stretch> stretches;
  for (int i = 0; i < curve.size(); ++i) {
    const SignChanges changes = inflections(curve.segment(i));
    result.certification = weaker(result.certification, changes.certification);
    if (changes.vanishes) continue;
    double t = 0.0;
    for (std::size_t k = 0; k <= changes.at.size(); ++k) {
      const double end = k < changes.at.size() ? changes.at[k].mid() : 1.0;
      const int sign = sign_on(curve.segment(i), t, end, known_to);
      if (sign != 0) stretches.push_back({{i, t}, sign});
      t = end;
    }
  }
  const std::size_t n = stretches.size();
  for (std::size_t k = curve.closed() ? 0 : 1; k < n; ++k)
    if (stretches[k].sign != stretches[(k + n - 1) % n].sign)
      result.positions.push_back(arcs.position(stretches[k].start));
  return result;
}

Features find_reversals(const Curve& curve, const ArcMap& arcs, double known_to) {
  Features result;
  for (int i = 0; i < curve.size(); ++i) {
    const Cusps inside = find_cusps(curve.segment(i));
    result.certification = weaker(result.certification, inside.certification);
    for (const double t : inside.at) result.positions.push_back(arcs.position({i, t}));
  }
  for (const Joint& joint : curve.joints()) {
    const JointSides sides = sides_of(curve.segment(joint.segment), curve.segment(curve.next(joint.segment)), known_to);
    const double explained = std::min(visible_jump, sides.before.tangent_error + sides.after.tangent_error);
    if (std::abs(angle_between(sides.before.tangent, sides.after.tangent)) >
        std::numbers::pi - std::max(reversal, explained))
      result.positions.push_back(arcs.position({joint.segment, 1.0}));
  }
  std::ranges::sort(result.positions);
  return result;
}

Metric features_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const ArcMap arcs(curve);
    const double known_to = rounding_of(fit.input);
    const Landmarks landmarks(curve, arcs, mean_chord(fit.input));
    Whereabouts inflection;
    const Features inflections = find_inflections(curve, arcs, known_to);
    for (const double s : inflections.positions) landmarks.count({s}, inflection);
    Whereabouts cusp;
    const Features reversals = find_reversals(curve, arcs, known_to);
    for (const double s : reversals.positions) landmarks.count({s}, cusp);
    Whereabouts loop;
    const Crossings crossings = self_intersections(curve);
    for (const Crossing& c : crossings.found) landmarks.count({arcs.position(c.first), arcs.position(c.second)}, loop);
    if (!crossings.complete) loop = {undefined, undefined, undefined};

    // Only whole counts are certified: nearness is arc length by quadrature, and the search for crossings carries no
    // bound of its rounding.
    using enum Method;
    return std::vector<Measurement>{column::inflections(inflection.all, method_of(inflections.certification)),
                                    column::inflections_at_nodes(inflection.at_nodes, sampled),
                                    column::inflections_at_joints(inflection.at_joints, sampled),
                                    column::cusps(cusp.all, method_of(reversals.certification)),
                                    column::cusps_at_nodes(cusp.at_nodes, sampled),
                                    column::cusps_at_joints(cusp.at_joints, sampled),
                                    column::loops(loop.all, sampled),
                                    column::loops_at_nodes(loop.at_nodes, sampled),
                                    column::loops_at_joints(loop.at_joints, sampled)};
  };
  return {.id = "features",
          .title = "Inflections, cusps and loops",
          .version = 4,
          .columns = {column::inflections, column::inflections_at_nodes, column::inflections_at_joints, column::cusps,
                      column::cusps_at_nodes, column::cusps_at_joints, column::loops, column::loops_at_nodes,
                      column::loops_at_joints},
          .measure = measure};
}

}  // namespace kappabench
