#include "metrics/arc_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "metrics/panel_rule.hpp"
#include "schemes/curve/arc_length.hpp"
#include "schemes/curve/steady_stretches.hpp"

namespace kappabench {
namespace {

constexpr std::size_t count = PanelRule::count;
constexpr std::size_t most_more = 200;  // panels than at first
constexpr double accuracy = 1e-13;
constexpr double accuracy_of_rate = 1e-11;

struct Panel {
  double t0;
  double t1;
  std::array<Jet, count> jets;
  Estimate length;
  Estimate bending;
  Estimate variation;
};

double finite_or_zero(double v) { return std::isfinite(v) ? v : 0.0; }

/// Rounding errors of what is computed from a jet: 16 units in the last place of the products that it is the difference
/// of, and the rounding of the coordinates, which is that of derivatives of the size of the speed.
struct Rounding {
  double speed;      ///< relative
  double curvature;  ///< absolute
  double rate;       ///< absolute

  explicit Rounding(const Jet& jet) {
    const double v = kappabench::speed(jet);
    const double bend = jet.d[2].norm() / v;
    speed = 0x1p-48 + speed_noise(jet);
    curvature = finite_or_zero(speed * (bend + 1.0) / v);
    rate = finite_or_zero(speed * (jet.d[3].norm() / v + 3.0 * bend * bend + 1.0) / (v * v));
  }
};

/// The integral of the square of what is known to `rounding`.
struct SquareAt {
  double value;
  double rounding;

  SquareAt(double ds, double root, double rounding_of_root)
      : value(ds * root * root), rounding(ds * rounding_of_root * (2.0 * std::abs(root) + rounding_of_root)) {}
};

/// Kronrod sums of values and their rounding errors at the nodes of a panel.
class Sums {
 public:
  void add(std::size_t node, double value, double rounding) {
    kronrod_ += PanelRule::get().weight[node] * value;
    gauss_ += PanelRule::get().gauss_weight[node] * value;
    rounding_ += PanelRule::get().weight[node] * rounding;
  }
  [[nodiscard]] Estimate estimate() const { return {kronrod_, kronrod_error(kronrod_, gauss_), rounding_}; }

 private:
  double kronrod_ = 0.0;
  double gauss_ = 0.0;
  double rounding_ = 0.0;
};

Panel make_panel(const Segment& segment, double t0, double t1) {
  Panel panel{t0, t1, {}, {}, {}, {}};
  std::array<double, count> t{};
  const double half = 0.5 * (t1 - t0);
  for (std::size_t i = 0; i < count; ++i) t[i] = 0.5 * (t0 + t1) + half * PanelRule::get().node[i];
  segment.jets(t, 3, panel.jets);
  Sums length;
  Sums bending;
  Sums variation;
  for (std::size_t i = 0; i < count; ++i) {
    const Jet& jet = panel.jets[i];
    const Rounding rounding(jet);
    const double ds = half * speed(jet);
    const SquareAt square(ds, finite_or_zero(curvature(jet)), rounding.curvature);
    const SquareAt rate_square(ds, finite_or_zero(curvature_derivative(jet)), rounding.rate);
    length.add(i, ds, rounding.speed * ds);
    bending.add(i, square.value, square.rounding);
    variation.add(i, rate_square.value, rate_square.rounding);
  }
  panel.length = length.estimate();
  panel.bending = bending.estimate();
  panel.variation = variation.estimate();
  return panel;
}

struct Totals {
  Estimate length;
  Estimate bending;
  Estimate variation;
};

Totals total(const std::vector<Panel>& panels) {
  Totals sum;
  for (const Panel& panel : panels) {
    sum.length += panel.length;
    sum.bending += panel.bending;
    sum.variation += panel.variation;
  }
  return sum;
}

/// Is the error of the panel too large for its share of the whole, and more than rounding?
bool too_large(const Panel& panel, const Totals& whole, std::size_t panels) {
  const auto above = [panels](const Estimate& part, double allowed) {
    return part.error > part.rounding && part.error * static_cast<double>(panels) > allowed;
  };
  return above(panel.length, accuracy * whole.length.value) || above(panel.bending, accuracy * whole.bending.value) ||
         above(panel.variation, accuracy_of_rate * whole.variation.value);
}

/// Bisects every panel whose error is too large for its share, in rounds, so that the order of work does not matter.
void refine(const Segment& segment, std::vector<Panel>& panels) {
  const std::size_t most = panels.size() + most_more;
  for (bool changed = true; changed && panels.size() < most;) {
    changed = false;
    const Totals whole = total(panels);
    std::vector<Panel> next;
    for (const Panel& panel : panels) {
      const double mid = 0.5 * (panel.t0 + panel.t1);
      const bool divisible = mid > panel.t0 && mid < panel.t1;
      if (!divisible || !too_large(panel, whole, panels.size())) {
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

std::vector<Panel> first_panels(const Segment& segment, double t0, double t1, std::span<const double> splits) {
  std::vector<double> bounds = steady_stretches(segment);
  bounds.insert(bounds.end(), splits.begin(), splits.end());
  std::erase_if(bounds, [&](double t) { return !(t > t0 && t < t1); });
  bounds.push_back(t0);
  bounds.push_back(t1);
  std::ranges::sort(bounds);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    if (bounds[i] < bounds[i + 1]) panels.push_back(make_panel(segment, bounds[i], bounds[i + 1]));
  }
  return panels;
}

void append_samples(const Panel& panel, double start, std::vector<ArcSample>& samples) {
  const PanelRule& rule = PanelRule::get();
  const double half = 0.5 * (panel.t1 - panel.t0);
  PanelRule::Values speeds;
  for (std::size_t i = 0; i < count; ++i) speeds[static_cast<Eigen::Index>(i)] = half * speed(panel.jets[i]);
  const PanelRule::Values lengths = rule.integral * speeds;
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double t = 0.5 * (panel.t0 + panel.t1) + half * rule.node[i];
    const double kappa = curvature(panel.jets[i]);
    const double rate = curvature_derivative(panel.jets[i]);
    const bool known = std::isfinite(kappa) && std::isfinite(rate);
    const double ds = known ? speeds[k] : 0.0;
    samples.push_back({t, start + lengths[k], rule.weight[i] * ds, rule.gauss_weight[i] * ds, finite_or_zero(kappa),
                       finite_or_zero(rate), Rounding(panel.jets[i]).curvature});
  }
}

}  // namespace

Estimate& Estimate::operator+=(const Estimate& other) {
  value += other.value;
  error += other.error;
  rounding += other.rounding;
  return *this;
}

double Estimate::to_accuracy() const {
  return error <= promised_accuracy * std::abs(value) + 2.0 * rounding ? value
                                                                       : std::numeric_limits<double>::quiet_NaN();
}

ArcQuadrature arc_quadrature(const Segment& segment, double t0, double t1, std::span<const double> splits) {
  std::vector<Panel> panels = first_panels(segment, t0, t1, splits);
  refine(segment, panels);
  const Totals whole = total(panels);
  ArcQuadrature result{{t0}, {}, whole.length, whole.bending, whole.variation};
  double start = 0.0;
  for (const Panel& panel : panels) {
    result.bounds.push_back(panel.t1);
    append_samples(panel, start, result.samples);
    start += panel.length.value;
  }
  return result;
}

std::vector<ArcSample> arc_samples(const Segment& segment, double t0, double t1, std::span<const double> splits) {
  return arc_quadrature(segment, t0, t1, splits).samples;
}

bool diverges_at_end(const Segment& segment, double t, double length) {
  const Jet jet = segment.jet(t, 3);
  constexpr double rest = 1e-8;         // over the mean speed: that of cusps
  constexpr double straight = 0x1p-26;  // sine of the angle between a and b: half of the digits
  if (!(speed(jet) <= rest * length)) return false;
  return std::abs(cross(jet.d[2], jet.d[3])) > straight * jet.d[2].norm() * jet.d[3].norm();
}

}  // namespace kappabench
