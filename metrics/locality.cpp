#include "metrics/locality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "metrics/correspondence.hpp"
#include "metrics/statistics.hpp"
#include "schemes/api/edit.hpp"

namespace kappabench {
namespace {

constexpr int directions = 8;
constexpr double support = 1e-12;      // deviation over the mean chord that counts as a change
constexpr double decay_floor = 1e-10;  // influence that is still above rounding

Vec2 direction(int k) {
  const double angle = 2.0 * std::numbers::pi * k / directions;
  return {std::cos(angle), std::sin(angle)};
}

/// Distance of every span from the nodes of `point`; 0 if the point has no node.
std::vector<int> distances_from(const std::vector<Span>& spans, int point, bool closed) {
  const int n = static_cast<int>(spans.size());
  std::vector<int> result(spans.size(), 0);
  for (int m = 0; m <= n; ++m) {  // node m starts span m and ends span m - 1
    const bool here =
        m < n ? spans[static_cast<std::size_t>(m)].from == point : n > 0 && !closed && spans.back().to == point;
    if (!here) continue;
    for (int k = 0; k < n; ++k) {
      int distance = k >= m ? k - m + 1 : m - k;
      if (closed) distance = std::min(distance, k >= m ? m + n - k : k + n - m + 1);
      int& best = result[static_cast<std::size_t>(k)];
      best = best == 0 ? distance : std::min(best, distance);
    }
  }
  return result;
}

Move moved(const Fit& fit, int point, const Vec2& by) {
  return {point, fit.input.points[static_cast<std::size_t>(point)] + by};
}

/// Largest deviation of an updated curve from a cold fit of the same input, over the mean chord; every point moved once
/// by 5 %. Infinite when only one of the two has a curve.
double refit_deviation(const Scheme& scheme, const Fit& fit) {
  const double chord = mean_chord(fit.input);
  double largest = 0.0;
  for (const int point : tried(fit.input.size())) {
    const Move move = moved(fit, point, 0.05 * chord * direction(point % directions));
    const Fit cold = scheme.fit(apply(fit.input, move));
    const Fit warm = scheme.refit(fit, move);
    if (!cold.curve && !warm.curve) continue;
    if (!cold.curve || !warm.curve) return std::numeric_limits<double>::infinity();
    const double d = deviation(spans(*cold.curve), spans(*warm.curve), fit.input.closed) / chord;
    if (!(d <= largest)) largest = d;
  }
  return largest;
}

}  // namespace

int LocalityProfile::reach(double threshold) const {
  int result = 0;
  for (std::size_t i = 0; i < influence.size(); ++i) {
    if (!(influence[i] <= threshold)) result = static_cast<int>(i) + 1;
  }
  return result;
}

LocalityProfile locality_profile(const Scheme& scheme, const Fit& fit, double displacement) {
  LocalityProfile profile{displacement, {}, 0, 0};
  const double step = displacement * mean_chord(fit.input);
  const std::vector<Span> original = spans(*fit.curve);
  for (const int point : tried(fit.input.size())) {
    const std::vector<int> distances = distances_from(original, point, fit.input.closed);
    for (int k = 0; k < directions; ++k) {
      const Fit other = scheme.fit(apply(fit.input, moved(fit, point, step * direction(k))));
      ++profile.fits;
      const auto deviations =
          other.curve ? span_deviations(original, spans(*other.curve), fit.input.closed) : std::nullopt;
      if (!deviations) {
        ++profile.failed;
        continue;
      }
      for (std::size_t i = 0; i < deviations->size(); ++i) {
        const auto distance = static_cast<std::size_t>(distances[i]);
        if (distance == 0) continue;
        if (profile.influence.size() < distance) profile.influence.resize(distance, 0.0);
        double& influence = profile.influence[distance - 1];
        if (!((*deviations)[i] / step <= influence)) influence = (*deviations)[i] / step;
      }
    }
  }
  return profile;
}

double decay_per_span(const LocalityProfile& profile) {
  double n = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double sum_xx = 0.0;
  double sum_xy = 0.0;
  for (std::size_t i = 0; i < profile.influence.size(); ++i) {
    if (!(profile.influence[i] > decay_floor) || !std::isfinite(profile.influence[i])) continue;
    const auto x = static_cast<double>(i + 1);
    const double y = std::log(profile.influence[i]);
    n += 1.0;
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  if (n < 3.0) return undefined;
  return std::exp((n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x));
}

Column column::locality_reach(int exponent, int percent) {
  return {
      fmt::format("locality_reach_1em{}_move_{}pct", exponent, percent), "spans",
      fmt::format("farthest span that deviates by more than 1e-{} of the displacement, a point moved by {} % of the "
                  "mean chord",
                  exponent, percent)};
}

Column column::locality_support(int percent) {
  return {fmt::format("locality_support_move_{}pct", percent), "spans",
          fmt::format("farthest span that deviates by more than 1e-12 mean chord, a point moved by {} % of the mean "
                      "chord",
                      percent)};
}

Metric locality_metric() {
  static constexpr int percents[] = {1, 5, 10};
  static constexpr int exponents[] = {2, 3, 6};
  std::vector<Column> columns;
  for (const int percent : percents) {
    for (const int exponent : exponents) columns.push_back(column::locality_reach(exponent, percent));
    columns.push_back(column::locality_support(percent));
  }
  columns.insert(columns.end(), {column::locality_decay, column::locality_failed, column::locality_refit_deviation});

  const auto measure = [](const Scheme& scheme, const Fit& fit) {
    using enum Method;
    std::vector<Measurement> row;
    double decay = undefined;
    double fits = 0.0;
    double failed = 0.0;
    for (const int percent : percents) {
      const LocalityProfile profile = locality_profile(scheme, fit, 0.01 * percent);
      fits += profile.fits;
      failed += profile.failed;
      const bool empty = profile.influence.empty();
      const auto reach = [&](double threshold) {
        return empty ? undefined : static_cast<double>(profile.reach(threshold));
      };
      for (const int exponent : exponents)
        row.push_back(column::locality_reach(exponent, percent)(reach(std::pow(10.0, -exponent)), sampled));
      row.push_back(column::locality_support(percent)(reach(support / profile.displacement), sampled));
      if (percent == 1) decay = decay_per_span(profile);
    }
    row.push_back(column::locality_decay(decay, sampled));
    row.push_back(column::locality_failed(fits > 0.0 ? failed / fits : undefined, sampled));
    row.push_back(column::locality_refit_deviation(refit_deviation(scheme, fit), sampled));
    return row;
  };
  return {.id = "locality",
          .title = "Reach of moving one point",
          .version = 1,
          .columns = std::move(columns),
          .measure = measure,
          .refits = true};
}

}  // namespace kappabench
