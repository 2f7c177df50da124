#include "metrics/invariance.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "metrics/correspondence.hpp"
#include "metrics/statistics.hpp"
#include "metrics/transformed.hpp"
#include "schemes/api/edit.hpp"

namespace kappabench {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double perturbation = 1e-9;  // of the mean chord

/// What all the tests below start from.
class Probe {
 public:
  Probe(const Scheme& scheme, const Fit& fit)
      : scheme_(scheme), fit_(fit), chord_(mean_chord(fit.input)), original_(spans(*fit.curve)) {}

  [[nodiscard]] double under(const Similarity& map) const {
    const Fit moved = scheme_.fit(transformed(fit_.input, map));
    if (!moved.curve) return infinite;
    std::vector<Span> expected = original_;
    for (Span& span : expected) {
      for (Vec2& p : span.samples) p = map(p);
    }
    return deviation(expected, spans(*moved.curve), fit_.input.closed) / (map.scale * chord_);
  }

  [[nodiscard]] double under_reversal() const {
    std::vector<int> order;
    for (int i = fit_.input.size(); i-- > 0;) order.push_back(i);
    const Fit other = scheme_.fit(reversed(fit_.input, order));
    if (!other.curve) return infinite;
    return deviation(original_, reversed(with_old_names(spans(*other.curve), order)), fit_.input.closed) / chord_;
  }

  /// Starts half way around.
  [[nodiscard]] double under_shift() const {
    if (!fit_.input.closed) return undefined;
    std::vector<int> order;
    const int n = fit_.input.size();
    order.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) order.push_back((i + n / 2) % n);
    const Fit other = scheme_.fit(reordered(fit_.input, order));
    if (!other.curve) return infinite;
    return deviation(original_, with_old_names(spans(*other.curve), order), true) / chord_;
  }

  /// Every point moved by 1e-9 of the mean chord, in directions that turn by the golden angle: deviation over
  /// displacement.
  [[nodiscard]] double sensitivity() const {
    const double step = perturbation * chord_;
    const Fit other = scheme_.fit(perturbed(fit_.input, step));
    if (!other.curve) return infinite;
    return deviation(original_, spans(*other.curve), fit_.input.closed) / step;
  }

  /// One insertion at a time, in the middle of a span between consecutive points.
  [[nodiscard]] std::vector<double> under_insertion() const {
    std::vector<double> deviations;
    const int n = fit_.input.size();
    for (const int k : tried(static_cast<int>(original_.size()))) {
      const Span& span = original_[static_cast<std::size_t>(k)];
      const bool consecutive = span.to == span.from + 1 || (fit_.input.closed && span.to == (span.from + 1) % n);
      if (!consecutive) continue;
      const int at = span.from + 1;
      const Fit more = scheme_.fit(apply(fit_.input, Insert{at, span.samples[samples_per_span / 2]}));
      if (!more.curve) {
        deviations.push_back(infinite);
        continue;
      }
      std::vector<int> order;
      for (int i = 0; i <= n; ++i) order.push_back(i < at ? i : i - 1);
      deviations.push_back(deviation(original_, with_old_names(spans(*more.curve, at), order), fit_.input.closed) /
                           chord_);
    }
    return deviations;
  }

  [[nodiscard]] double chord() const { return chord_; }

 private:
  const Scheme& scheme_;
  const Fit& fit_;
  double chord_;
  std::vector<Span> original_;
};

constexpr std::array polygon_sizes{3, 4, 5, 6, 8, 12, 16};

double distance_from_circle(const Scheme& scheme, int n) {
  Input input;
  input.closed = true;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    input.points.emplace_back(std::cos(angle), std::sin(angle));
  }
  const Fit fit = scheme.fit(input);
  if (fit.report.outcome == Outcome::unsupported_input) return undefined;
  if (!fit.curve) return infinite;
  double largest = 0.0;
  for (const Jet& jet : sample(*fit.curve, 65, 0).jets) {
    const double deviation = std::abs(jet.position().norm() - 1.0);
    if (!(deviation <= largest)) largest = deviation;
  }
  return largest;
}

}  // namespace

Metric invariance_metric() {
  const auto measure = [](const Scheme& scheme, const Fit& fit) {
    const Probe probe(scheme, fit);
    const Similarity moved{3.7, 0.7, probe.chord() * Vec2(12.0, -5.0), false};
    const Similarity mirrored{1.0, 0.0, Vec2::Zero(), true};
    const std::vector<double> insertions = probe.under_insertion();
    using enum Method;
    return std::vector<Measurement>{column::deviation_similarity(probe.under(moved), sampled),
                                    column::deviation_mirror(probe.under(mirrored), sampled),
                                    column::deviation_reversal(probe.under_reversal(), sampled),
                                    column::deviation_cyclic_shift(probe.under_shift(), sampled),
                                    column::deviation_extensionality_mean(mean(insertions), sampled),
                                    column::deviation_extensionality_max(largest(insertions), sampled),
                                    column::sensitivity(probe.sensitivity(), sampled)};
  };
  using namespace column;
  return {.id = "invariance",
          .title = "Invariance and stability of the scheme",
          .version = 1,
          .columns = {deviation_similarity, deviation_mirror, deviation_reversal, deviation_cyclic_shift,
                      deviation_extensionality_mean, deviation_extensionality_max, sensitivity},
          .measure = measure,
          .refits = true};
}

Column column::roundness(int corners) {
  return {fmt::format("roundness_{}", corners), "1",
          fmt::format("regular {}-gon: largest distance from its circle over the radius; NaN if the scheme takes no "
                      "closed input",
                      corners)};
}

Metric roundness_metric() {
  std::vector<Column> columns;
  for (const int n : polygon_sizes) columns.push_back(column::roundness(n));
  const auto measure = [](const Scheme& scheme, const Fit&) {
    std::vector<Measurement> row;
    for (const int n : polygon_sizes)
      row.push_back(column::roundness(n)(distance_from_circle(scheme, n), Method::sampled));
    return row;
  };
  return {.id = "roundness",
          .title = "Regular polygons against the circle",
          .version = 1,
          .columns = std::move(columns),
          .measure = measure,
          .refits = true};
}

}  // namespace kappabench
