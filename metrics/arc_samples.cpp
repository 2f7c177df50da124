#include "metrics/arc_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "metrics/panel_rule.hpp"

namespace kappabench {
namespace {

constexpr std::size_t count = PanelRule::count;
constexpr std::size_t most_panels = 200;
constexpr double accuracy = 1e-13;
constexpr double accuracy_of_rate = 1e-11;

struct Integrals {
  double length = 0.0;
  double bending = 0.0;
  double variation = 0.0;
};

struct Panel {
  double t0;
  double t1;
  std::array<Jet, count> jets;
  Integrals value;
  Integrals error;
};

double finite_or_zero(double v) { return std::isfinite(v) ? v : 0.0; }

Panel make_panel(const Segment& segment, double t0, double t1) {
  Panel panel{t0, t1, {}, {}, {}};
  std::array<double, count> t{};
  const double half = 0.5 * (t1 - t0);
  for (std::size_t i = 0; i < count; ++i) t[i] = 0.5 * (t0 + t1) + half * PanelRule::get().node[i];
  segment.jets(t, 3, panel.jets);
  Integrals gauss;
  for (std::size_t i = 0; i < count; ++i) {
    const double v = half * speed(panel.jets[i]);
    const double kappa = finite_or_zero(curvature(panel.jets[i]));
    const double rate = finite_or_zero(curvature_derivative(panel.jets[i]));
    for (auto& [sum, weight] :
         {std::pair{&panel.value, PanelRule::get().weight[i]}, std::pair{&gauss, PanelRule::get().gauss_weight[i]}}) {
      sum->length += weight * v;
      sum->bending += weight * v * kappa * kappa;
      sum->variation += weight * v * rate * rate;
    }
  }
  panel.error = {kronrod_error(panel.value.length, gauss.length), kronrod_error(panel.value.bending, gauss.bending),
                 kronrod_error(panel.value.variation, gauss.variation)};
  return panel;
}

/// Largest error of the panel, each relative to what is allowed for the whole.
double excess(const Panel& panel, const Integrals& whole, double noise) {
  const double unit = whole.length > 0.0 ? 1.0 / whole.length : 0.0;
  const double bending = std::max(whole.bending, 1e-6 * unit);
  const double variation = std::max(whole.variation, 1e-6 * unit * unit * unit);
  const auto ratio = [](double error, double allowed) { return error > 0.0 ? error / allowed : 0.0; };
  return std::max({ratio(panel.error.length, (accuracy + noise) * whole.length),
                   ratio(panel.error.bending, (accuracy + noise) * bending),
                   ratio(panel.error.variation, (accuracy_of_rate + 100.0 * noise) * variation)});
}

Integrals total(const std::vector<Panel>& panels) {
  Integrals sum;
  for (const Panel& panel : panels) {
    sum.length += panel.value.length;
    sum.bending += panel.value.bending;
    sum.variation += panel.value.variation;
  }
  return sum;
}

/// Bisects every panel whose error is too large for its share, in rounds, so that the order of work does not matter.
void refine(const Segment& segment, std::vector<Panel>& panels) {
  const double noise = panels.empty() ? 0.0 : speed_noise(segment, 0.5 * (panels.front().t0 + panels.back().t1));
  for (bool changed = true; changed && panels.size() < most_panels;) {
    changed = false;
    const Integrals whole = total(panels);
    std::vector<Panel> next;
    for (const Panel& panel : panels) {
      const double mid = 0.5 * (panel.t0 + panel.t1);
      const bool divisible = mid > panel.t0 && mid < panel.t1;
      if (!divisible || !(excess(panel, whole, noise) * static_cast<double>(panels.size()) > 1.0)) {
        next.push_back(panel);
        continue;
      }
      next.push_back(make_panel(segment, panel.t0, mid));
      next.push_back(make_panel(segment, mid, panel.t1));
      changed = true;
    }
    panels = std::move(next);
  }
}

}  // namespace

std::vector<ArcSample> arc_samples(const Segment& segment, double t0, double t1, std::span<const double> splits) {
  std::vector<double> bounds{t0};
  for (const double t : splits) {
    if (t > t0 && t < t1) bounds.push_back(t);
  }
  bounds.push_back(t1);
  std::sort(bounds.begin(), bounds.end());
  std::vector<Panel> panels;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    if (bounds[i] < bounds[i + 1]) panels.push_back(make_panel(segment, bounds[i], bounds[i + 1]));
  }
  refine(segment, panels);

  std::vector<ArcSample> samples;
  double start = 0.0;
  for (const Panel& panel : panels) {
    const double half = 0.5 * (panel.t1 - panel.t0);
    PanelRule::Values speeds;
    for (std::size_t i = 0; i < count; ++i) speeds[static_cast<Eigen::Index>(i)] = half * speed(panel.jets[i]);
    const PanelRule::Values lengths = PanelRule::get().integral * speeds;
    for (std::size_t i = 0; i < count; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const double kappa = curvature(panel.jets[i]);
      const double rate = curvature_derivative(panel.jets[i]);
      if (!std::isfinite(kappa) || !std::isfinite(rate)) continue;
      const double t = 0.5 * (panel.t0 + panel.t1) + half * PanelRule::get().node[i];
      samples.push_back({t, start + lengths[k], PanelRule::get().weight[i] * speeds[k], kappa, rate});
    }
    start += panel.value.length;
  }
  return samples;
}

}  // namespace kappabench
