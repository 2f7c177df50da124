#include "metrics/arc_map.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/curve/arc_length.hpp"
#include "schemes/curve/steady_stretches.hpp"

namespace kappabench {
namespace {

constexpr double aimed_at = 1e-13;
constexpr double promised = 1e-10;
constexpr int max_depth = 12;              // below a steady stretch
constexpr std::size_t most_panels = 1000;  // of a segment: what is not smooth must not be bisected for ever

/// Right up to a factor of 3, as the speed is on each stretch.
double rough_length(const Segment& segment, const std::vector<double>& ends) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    length += (ends[i + 1] - ends[i]) * speed(segment.jet(0.5 * (ends[i] + ends[i + 1]), 1));
  return length;
}

}  // namespace

ArcMap::ArcMap(const Curve& curve) : closed_(curve.closed()), starts_{0.0} {
  for (int i = 0; i < curve.size(); ++i) {
    first_.push_back(panels_.size());
    append_segment(curve.segment(i));
    double length = 0.0;
    for (std::size_t k = first_.back(); k < panels_.size(); ++k) {
      panels_[k].start = length;
      length += panels_[k].length;
    }
    starts_.push_back(starts_.back() + length);
  }
  first_.push_back(panels_.size());
}

void ArcMap::append_segment(const Segment& segment) {
  const std::vector<double> ends = steady_stretches(segment);
  const double rough = rough_length(segment, ends);
  Aim aim{aimed_at * rough};
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) append_panels(segment, ends[i], ends[i + 1], 0, aim);
  accurate_ = accurate_ && aim.missed <= promised * rough + aim.noise;
}

void ArcMap::append_panels(const Segment& segment, double t0, double t1, int depth, Aim& aim) {
  const PanelRule& rule = PanelRule::get();
  const double half = 0.5 * (t1 - t0);
  const double mid = 0.5 * (t0 + t1);
  std::array<double, PanelRule::count> t{};
  std::array<Jet, PanelRule::count> jets;
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = mid + half * rule.node[i];
  segment.jets(t, 1, jets);
  PanelRule::Values speeds;
  double kronrod = 0.0;
  double gauss = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double v = half * speed(jets[i]);
    speeds[static_cast<Eigen::Index>(i)] = v;
    kronrod += rule.weight[i] * v;
    gauss += rule.gauss_weight[i] * v;
  }
  const double error = kronrod_error(kronrod, gauss);
  const double noise = speed_noise(jets[PanelRule::count / 2]) * kronrod;
  const bool enough = depth == max_depth || panels_.size() - first_.back() >= most_panels;
  if (error <= aim.error + noise || enough || !std::isfinite(kronrod)) {
    panels_.push_back({t0, t1, 0.0, rule.legendre * speeds, kronrod});
    aim.missed += error;
    aim.noise += noise;
    return;
  }
  append_panels(segment, t0, mid, depth + 1, aim);
  append_panels(segment, mid, t1, depth + 1, aim);
}

double ArcMap::segment_length(int segment) const {
  const auto i = static_cast<std::size_t>(segment);
  return starts_[i + 1] - starts_[i];
}

double ArcMap::position(const CurvePlace& place) const {
  const auto i = static_cast<std::size_t>(place.segment);
  if (place.t <= 0.0) return starts_[i];
  if (place.t >= 1.0) return starts_[i + 1];
  const auto begin = panels_.begin() + static_cast<std::ptrdiff_t>(first_[i]);
  const auto end = panels_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]);
  const auto panel =
      std::prev(std::upper_bound(begin + 1, end, place.t, [](double t, const Panel& p) { return t < p.t0; }));
  const double x = (2.0 * place.t - panel->t0 - panel->t1) / (panel->t1 - panel->t0);
  return starts_[i] + panel->start + legendre_integral(panel->speed, x);
}

CurvePlace ArcMap::place(double s) const {
  if (closed_ && length() > 0.0) {
    s = std::fmod(s, length());
    if (s < 0.0) s += length();
  }
  s = std::clamp(s, 0.0, length());
  const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - starts_.begin()) - 1;
  const int segment = static_cast<int>(i);
  const double target = s - starts_[i];
  if (target <= 0.0) return {segment, 0.0};
  if (target >= starts_[i + 1] - starts_[i]) return {segment, 1.0};
  const auto begin = panels_.begin() + static_cast<std::ptrdiff_t>(first_[i]);
  const auto end = panels_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]);
  const auto panel =
      std::prev(std::upper_bound(begin + 1, end, target, [](double v, const Panel& p) { return v < p.start; }));
  // Newton's method on the polynomial arc length, kept in a shrinking bracket.
  const double goal = target - panel->start;
  double lo = -1.0;
  double hi = 1.0;
  double x = std::clamp(2.0 * goal / panel->length - 1.0, -1.0, 1.0);
  for (int step = 0; step < 60; ++step) {
    const double excess = legendre_integral(panel->speed, x) - goal;
    if (std::abs(excess) <= 1e-15 * panel->length) break;
    (excess < 0.0 ? lo : hi) = x;
    const double newton = x - excess / legendre_value(panel->speed, x);
    const double next = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
    if (std::abs(next - x) <= 1e-16) break;
    x = next;
  }
  return {segment, 0.5 * (panel->t0 + panel->t1) + 0.5 * (panel->t1 - panel->t0) * x};
}

}  // namespace kappabench
