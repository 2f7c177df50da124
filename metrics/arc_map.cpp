#include "metrics/arc_map.hpp"

#include <algorithm>
#include <cmath>

namespace kappabench {
namespace {

constexpr double accuracy = 1e-13;
constexpr int max_depth = 40;
constexpr std::size_t most_panels = 400;  // of a segment: rounding noise must not be bisected for ever

}  // namespace

ArcMap::ArcMap(const Curve& curve) : closed_(curve.closed()), starts_{0.0} {
  for (int i = 0; i < curve.size(); ++i) {
    first_.push_back(panels_.size());
    const Segment& segment = curve.segment(i);
    append_panels(segment, 0.0, 1.0, accuracy + speed_noise(segment, 0.5), 0);
    double length = 0.0;
    for (std::size_t k = first_.back(); k < panels_.size(); ++k) {
      panels_[k].start = length;
      length += panels_[k].length;
    }
    starts_.push_back(starts_.back() + length);
  }
  first_.push_back(panels_.size());
}

void ArcMap::append_panels(const Segment& segment, double t0, double t1, double allowed, int depth) {
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
  if (depth == 0) allowed *= kronrod;
  const bool accurate = kronrod_error(kronrod, gauss) <= allowed;
  const bool enough = depth == max_depth || panels_.size() - first_.back() >= most_panels;
  if (accurate || enough || !std::isfinite(kronrod)) {
    panels_.push_back({t0, t1, 0.0, rule.legendre * speeds, kronrod});
    return;
  }
  append_panels(segment, t0, mid, allowed, depth + 1);
  append_panels(segment, mid, t1, allowed, depth + 1);
}

double ArcMap::segment_length(int segment) const {
  const auto i = static_cast<std::size_t>(segment);
  return starts_[i + 1] - starts_[i];
}

double ArcMap::position(const Place& place) const {
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

Place ArcMap::place(double s) const {
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
