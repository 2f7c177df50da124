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
  bool least;       ///< of |curvature|, not largest
};

/// A curvature of 0 is the least, be it a maximum or a minimum of the signed one.
bool is_least(const TurningPoint& turn, double curvature, double unit) {
  constexpr double rounding = 1e-9;  // as turning points are told from it
  return std::abs(curvature) <= rounding * unit || turn.maximum == (curvature < 0.0);
}

std::vector<Extremum> extrema_of(const Curve& curve, const CurvatureProfile& profile, const ArcMap& arcs) {
  std::vector<Extremum> extrema;
  for (const TurningPoint& turn : turning_points(profile, curve.closed())) {
    const ProfilePoint& point = profile.points[turn.index];
    extrema.push_back({arcs.position(point.place), is_least(turn, point.curvature, profile.unit)});
  }
  std::sort(extrema.begin(), extrema.end(),
            [](const Extremum& a, const Extremum& b) { return a.position < b.position; });
  return extrema;
}

double distance_along(double a, double b, const Curve& curve, double length) {
  const double direct = std::abs(a - b);
  return curve.closed() ? std::min(direct, length - direct) : direct;
}

/// The distance to the nearest of `extrema` (ascending, not empty): a neighbour in order, or around the closure.
double distance_to_nearest(const std::vector<Extremum>& extrema, double position, const Curve& curve, double length) {
  const auto after = std::lower_bound(extrema.begin(), extrema.end(), position,
                                      [](const Extremum& e, double p) { return e.position < p; });
  const auto to = [&](const Extremum& e) { return distance_along(e.position, position, curve, length); };
  double least = std::min(to(extrema.front()), to(extrema.back()));
  if (after != extrema.end()) least = std::min(least, to(*after));
  if (after != extrema.begin()) least = std::min(least, to(*std::prev(after)));
  return least;
}

/// Is |curvature| least at all extrema within `reach`? Where curvature jumps a node may be at a minimum on one side and
/// at a maximum on the other.
bool all_least_within(const std::vector<Extremum>& extrema, double reach, double position, const Curve& curve,
                      double length) {
  const auto all_least_at = [&](double s) {
    auto e = std::lower_bound(extrema.begin(), extrema.end(), s - reach,
                              [](const Extremum& extremum, double p) { return extremum.position < p; });
    while (e != extrema.end() && e->position <= s + reach && e->least) ++e;
    return e == extrema.end() || e->position > s + reach;
  };
  return all_least_at(position) &&
         (!curve.closed() || (all_least_at(position - length) && all_least_at(position + length)));
}

/// The mean distance of an input point from its neighbours, or from the only one. A curve that passes its point twice,
/// as a loop does, has one local chord there.
double local_chord(const Input& input, int point) {
  const int n = input.size();
  if (point < 0 || point >= n) return mean_chord(input);
  const auto at = [&](int i) { return input.points[static_cast<std::size_t>((i + n) % n)]; };
  std::vector<double> chords;
  for (const int neighbour : {point - 1, point + 1})
    if (input.closed || (neighbour >= 0 && neighbour < n)) chords.push_back((at(neighbour) - at(point)).norm());
  const double local = mean(chords);
  return local > 0.0 ? local : mean_chord(input);
}

}  // namespace

Metric extremum_offset_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const CurvatureProfile profile = curvature_profile(curve, rounding_of(fit.input));
    const ArcMap arcs(curve);
    const std::vector<PlacedNode> nodes = nodes_in_order(curve, arcs);
    const std::vector<Extremum> extrema = extrema_of(curve, profile, arcs);
    std::vector<double> offsets;
    double hits = 0.0;
    double minima = 0.0;
    for (const PlacedNode& node : nodes) {
      if (!arcs.accurate() || extrema.empty() || at_end(node, curve, arcs)) continue;
      const double local = local_chord(fit.input, node.node.point);
      const double distance = distance_to_nearest(extrema, node.position, curve, arcs.length());
      offsets.push_back(distance / local);
      if (offsets.back() > coincident) continue;
      hits += 1.0;
      if (all_least_within(extrema, coincident * local, node.position, curve, arcs.length())) minima += 1.0;
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
          .version = 4,
          .columns = {extremum_offset_mean, extremum_offset_max, nodes_at_extremum, nodes_at_curvature_minimum},
          .measure = measure};
}

}  // namespace kappabench
