#include "metrics/angle_turned.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "metrics/arc_samples.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/curve/steady_stretches.hpp"
#include "schemes/curve/tangents.hpp"

namespace kappabench {
namespace {

constexpr double rest = 1e-8;    // speed over the mean speed, as for cusps
constexpr double beside = 1e-6;  // in t: within it of a cusp, directions and inflections are rounding's

bool near_any(const std::vector<double>& cusps, double t) {
  return std::ranges::any_of(cusps, [t](double cusp) { return std::abs(cusp - t) < beside; });
}

/// Where the segment stops, ends included.
std::vector<double> stops_of(const Segment& segment, double length) {
  std::vector<double> stops = cusps(segment);
  for (const double end : {0.0, 1.0})
    if (speed(segment.jet(end, 1)) <= rest * length) stops.push_back(end);
  return stops;
}

/// Ends and, in between, inflections and cusps: the curvature has one sign from each to the next.
std::vector<double> ends_of_pieces(const Segment& segment, const std::vector<double>& stops) {
  std::vector<double> ends{0.0, 1.0};
  for (const RootBracket& bracket : inflections(segment).at)
    if (!near_any(stops, bracket.mid())) ends.push_back(bracket.mid());
  for (const double stop : stops)
    if (stop > 0.0 && stop < 1.0) ends.push_back(stop);
  std::ranges::sort(ends);
  return ends;
}

/// From t0 to t1, between which curvature has one sign, by way of `through`.
double turned_between(const Segment& segment, double t0, double t1, const std::vector<double>& through, double slow) {
  double angle = 0.0;
  Vec2 before = unit_tangent(segment, t0, Side::after, slow);
  const auto turn_to = [&](const Vec2& direction) {
    angle += angle_between(before, direction);
    before = direction;
  };
  for (const double t : through)
    if (t > t0 && t < t1) turn_to(unit_tangent(segment, t, Side::after, slow));
  turn_to(unit_tangent(segment, t1, Side::before, slow));
  return std::abs(angle);
}

double turned_at_constant_speed(const Segment& segment, double t0, double t1) {
  double angle = 0.0;
  for (const ArcSample& sample : arc_samples(segment, t0, t1)) angle += sample.weight * sample.curvature;
  return std::abs(angle);
}

}  // namespace

double angle_turned(const Segment& segment, double length) {
  const std::vector<double> stops = stops_of(segment, length);
  const std::vector<double> ends = ends_of_pieces(segment, stops);
  std::vector<double> through = steady_stretches(segment);
  std::erase_if(through, [&](double t) { return near_any(stops, t); });
  const bool constant_speed = has_constant_speed(segment);
  double turned = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    turned += constant_speed ? turned_at_constant_speed(segment, ends[i], ends[i + 1])
                             : turned_between(segment, ends[i], ends[i + 1], through, rest * length);
  }
  return turned;
}

}  // namespace kappabench
