#include "metrics/curvature_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/curve/rounding.hpp"

namespace kappabench {
namespace {

constexpr double beside = 1e-6;  // how far from a cusp or a resting end curvature is read, in t
constexpr double rounding = 1e-9;
constexpr double infinite = std::numeric_limits<double>::infinity();

using Kind = ProfilePoint::Kind;

double curvature_at(const Segment& segment, double t) { return curvature(segment.jet(t, 2)); }

ProfilePoint point_at(const Segment& segment, const CurvePlace& place, Kind kind, double known_to) {
  const Jet jet = segment.jet(place.t, 2);
  const double error = curvature_error(jet.d[1], jet.d[2], rounding_error(segment, jet.position(), known_to));
  return {place, curvature(jet), kind, std::isfinite(error) ? error : 0.0};
}

ProfilePoint end_point(const Segment& segment, const CurvePlace& place, double known_to) {
  const ProfilePoint end = point_at(segment, place, Kind::end, known_to);
  const bool rests = !(speed(segment.jet(place.t, 1)) > 1e-8 * speed(segment.jet(0.5, 1)));
  if (std::isfinite(end.curvature) && !rests) return end;
  const double inside = place.t < 0.5 ? beside : 1.0 - beside;
  const ProfilePoint near = point_at(segment, {place.segment, inside}, Kind::end, known_to);
  return {place, std::isfinite(near.curvature) ? near.curvature : 0.0, Kind::end, near.error};
}

void append_segment(const Segment& segment, int index, double known_to, CurvatureProfile& profile) {
  std::vector<ProfilePoint> inside;
  const Cusps stops = find_cusps(segment);
  for (const double t : stops.at) {
    for (const double side : {t - beside, t + beside}) {
      const double kappa = curvature_at(segment, side);
      inside.push_back({{index, t}, kappa < 0.0 ? -infinite : infinite, Kind::cusp});
    }
  }
  const SignChanges extrema = curvature_extrema(segment);
  profile.certification = weaker(profile.certification, weaker(stops.certification, extrema.certification));
  for (const RootBracket& bracket : extrema.at) {
    const double t = bracket.mid();
    const bool at_cusp =
        std::any_of(stops.at.begin(), stops.at.end(), [t](double c) { return std::abs(c - t) < beside; });
    const ProfilePoint extremum = point_at(segment, {index, t}, Kind::extremum, known_to);
    if (!at_cusp && std::isfinite(extremum.curvature)) inside.push_back(extremum);
  }
  std::stable_sort(inside.begin(), inside.end(),
                   [](const ProfilePoint& a, const ProfilePoint& b) { return a.place.t < b.place.t; });
  profile.points.push_back(end_point(segment, {index, 0.0}, known_to));
  profile.points.insert(profile.points.end(), inside.begin(), inside.end());
  profile.points.push_back(end_point(segment, {index, 1.0}, known_to));
}

}  // namespace

Method method_of(Certification certification) {
  switch (certification) {
    case Certification::exact:
      return Method::exact;
    case Certification::enclosed:
      return Method::enclosed;
    case Certification::sampled:
      return Method::sampled;
  }
  return Method::sampled;
}

std::span<const ProfilePoint> CurvatureProfile::of_segment(int segment) const {
  const auto i = static_cast<std::size_t>(segment);
  return std::span{points}.subspan(first[i], first[i + 1] - first[i]);
}

std::vector<double> CurvatureProfile::splits(int segment) const {
  std::vector<double> result;
  for (const ProfilePoint& point : of_segment(segment)) {
    if (point.kind != ProfilePoint::Kind::end) result.push_back(point.place.t);
  }
  return result;
}

bool CurvatureProfile::cusp_within(int segment, double t0, double t1) const {
  const auto inside = of_segment(segment);
  return std::any_of(inside.begin(), inside.end(), [&](const ProfilePoint& point) {
    return point.kind == ProfilePoint::Kind::cusp && point.place.t >= t0 && point.place.t <= t1;
  });
}

CurvatureProfile curvature_profile(const Curve& curve, double known_to) {
  CurvatureProfile profile;
  profile.known_to = known_to;
  const double length = ArcMap(curve).length();
  profile.unit = length > 0.0 ? 1.0 / length : std::numeric_limits<double>::min();
  for (int i = 0; i < curve.size(); ++i) {
    profile.first.push_back(profile.points.size());
    append_segment(curve.segment(i), i, known_to, profile);
  }
  profile.first.push_back(profile.points.size());
  double least = infinite;
  double most = -least;
  for (const ProfilePoint& point : profile.points) {
    if (point.kind == ProfilePoint::Kind::cusp) continue;
    least = std::min(least, point.curvature);
    most = std::max(most, point.curvature);
  }
  profile.range = std::max(0.0, most - least);
  return profile;
}

std::vector<ProfilePoint> profile_within(const Curve& curve, const CurvatureProfile& profile,
                                         std::span<const Part> parts) {
  std::vector<ProfilePoint> within;
  for (const Part& part : parts) {
    const auto segment = profile.of_segment(part.segment);
    const auto end = [&](double t) {
      if (t == 0.0) return segment.front();
      if (t == 1.0) return segment.back();
      return point_at(curve.segment(part.segment), {part.segment, t}, Kind::end, profile.known_to);
    };
    within.push_back(end(part.t0));
    for (const ProfilePoint& point : segment)
      if (point.place.t > part.t0 && point.place.t < part.t1) within.push_back(point);
    within.push_back(end(part.t1));
  }
  return within;
}

std::vector<TurningPoint> turning_points(std::span<const ProfilePoint> sequence, double unit, double prominence) {
  const auto value = [&](std::size_t i) { return sequence[i].curvature; };
  const auto differ = [&](std::size_t low, std::size_t high) {
    const double scale = std::max({std::abs(value(low)), std::abs(value(high)), unit});
    if (std::isinf(scale)) return value(high) > value(low);
    const double explained = sequence[low].error + sequence[high].error;
    return value(high) - value(low) > std::max({prominence, explained, rounding * scale});
  };
  std::vector<TurningPoint> found;
  int direction = 0;
  std::size_t lowest = 0;
  std::size_t highest = 0;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (value(i) < value(lowest)) lowest = i;
    if (value(i) > value(highest)) highest = i;
    if (direction == 0) {
      if (differ(lowest, highest)) direction = highest > lowest ? 1 : -1;
    } else if (direction > 0 && differ(i, highest)) {
      found.push_back({highest, true});
      direction = -1;
      lowest = i;
    } else if (direction < 0 && differ(lowest, i)) {
      found.push_back({lowest, false});
      direction = 1;
      highest = i;
    }
    if (direction > 0) lowest = i;
    if (direction < 0) highest = i;
  }
  return found;
}

std::vector<TurningPoint> turning_points(const CurvatureProfile& profile, bool closed, double prominence) {
  if (!closed) return turning_points(profile.points, profile.unit, prominence);
  // Around, from the largest curvature back to it.
  const std::size_t n = profile.points.size();
  const auto peak = static_cast<std::size_t>(
      std::max_element(profile.points.begin(), profile.points.end(),
                       [](const ProfilePoint& a, const ProfilePoint& b) { return a.curvature < b.curvature; }) -
      profile.points.begin());
  std::vector<ProfilePoint> around;
  for (std::size_t i = 0; i <= n; ++i) around.push_back(profile.points[(peak + i) % n]);
  std::vector<TurningPoint> found = turning_points(around, profile.unit, prominence);
  if (!found.empty()) found.push_back({0, true});
  for (TurningPoint& point : found) point.index = (point.index + peak) % n;
  return found;
}

}  // namespace kappabench
