#include "metrics/extremum_offset.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/curvature_profile.hpp"
#include "metrics/node_pieces.hpp"
#include "metrics/statistics.hpp"

namespace kappabench {
namespace {

constexpr double coincident = 1e-6;  // offset over the local chord

struct Extremum {
  double position;  ///< arc length
  bool maximum;     ///< of signed curvature
  double curvature;
};

std::vector<Extremum> extrema_of(const Curve& curve, const CurvatureProfile& profile, const ArcMap& arcs) {
  std::vector<Extremum> extrema;
  for (const TurningPoint& turn : turning_points(profile, curve.closed())) {
    const ProfilePoint& point = profile.points[turn.index];
    extrema.push_back({arcs.position(point.place), turn.maximum, point.curvature});
  }
  std::sort(extrema.begin(), extrema.end(),
            [](const Extremum& a, const Extremum& b) { return a.position < b.position; });
  return extrema;
}

double distance_along(double a, double b, const Curve& curve, double length) {
  const double direct = std::abs(a - b);
  return curve.closed() ? std::min(direct, length - direct) : direct;
}

/// The nearest of `extrema` (ascending, not empty): a neighbour in order, or around the closure.
const Extremum& nearest(const std::vector<Extremum>& extrema, double position, const Curve& curve, double length) {
  const auto after = std::lower_bound(extrema.begin(), extrema.end(), position,
                                      [](const Extremum& e, double p) { return e.position < p; });
  const Extremum* best = &extrema.front();
  const auto consider = [&](const Extremum& candidate) {
    const double d = distance_along(candidate.position, position, curve, length);
    if (d < distance_along(best->position, position, curve, length)) best = &candidate;
  };
  if (after != extrema.end()) consider(*after);
  if (after != extrema.begin()) consider(*std::prev(after));
  consider(extrema.back());
  return *best;
}

Vec2 at(const Curve& curve, const PlacedNode& node) {
  return curve.segment(node.node.segment).jet(node.node.t, 0).position();
}

}  // namespace

Metric extremum_offset_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const CurvatureProfile profile = curvature_profile(curve);
    const ArcMap arcs(curve);
    const std::vector<PlacedNode> nodes = nodes_in_order(curve, arcs);
    const std::vector<Extremum> extrema = extrema_of(curve, profile, arcs);
    std::vector<double> offsets;
    double hits = 0.0;
    double minima = 0.0;
    const std::size_t n = nodes.size();
    for (std::size_t i = 0; i < n && !extrema.empty(); ++i) {
      if (at_end(nodes[i], curve, arcs)) continue;
      const Vec2 here = at(curve, nodes[i]);
      const Vec2 before = i > 0 ? at(curve, nodes[i - 1]) : curve.closed() ? at(curve, nodes.back()) : curve.start();
      const Vec2 after = i + 1 < n ? at(curve, nodes[i + 1]) : curve.closed() ? at(curve, nodes.front()) : curve.end();
      const double chords = (here - before).norm() + (after - here).norm();
      const double local = chords > 0.0 ? 0.5 * chords : mean_chord(fit.input);
      const Extremum& extremum = nearest(extrema, nodes[i].position, curve, arcs.length());
      const double offset = distance_along(extremum.position, nodes[i].position, curve, arcs.length()) / local;
      offsets.push_back(offset);
      if (offset > coincident) continue;
      hits += 1.0;
      if (extremum.maximum == (extremum.curvature < 0.0)) minima += 1.0;
    }
    const double fraction = offsets.empty() ? undefined : hits / static_cast<double>(offsets.size());
    // Arc lengths are quadrature, and so is what is within some distance of a node.
    using enum Method;
    return std::vector<Measurement>{
        column::extremum_offset_mean(mean(offsets), sampled), column::extremum_offset_max(largest(offsets), sampled),
        column::nodes_at_extremum(fraction, sampled), column::nodes_at_curvature_minimum(minima, sampled)};
  };
  using namespace column;
  return {.id = "extremum_offset",
          .title = "Distance from points to curvature extrema",
          .version = 2,
          .columns = {extremum_offset_mean, extremum_offset_max, nodes_at_extremum, nodes_at_curvature_minimum},
          .measure = measure};
}

}  // namespace kappabench
