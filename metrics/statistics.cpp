#include "metrics/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace kappabench {

namespace {

std::vector<double> without_nan(std::span<const double> values) {
  std::vector<double> kept;
  std::ranges::copy_if(values, std::back_inserter(kept), [](double v) { return !std::isnan(v); });
  return kept;
}

}  // namespace

double mean(std::span<const double> values) {
  const std::vector<double> kept = without_nan(values);
  return kept.empty() ? undefined : std::accumulate(kept.begin(), kept.end(), 0.0) / static_cast<double>(kept.size());
}

double median(std::vector<double> values) {
  values = without_nan(values);
  if (values.empty()) return undefined;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double quantile(std::vector<double> values, double share) {
  values = without_nan(values);
  if (values.empty()) return undefined;
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  return values[static_cast<std::size_t>(std::min(share * n, n - 1.0))];
}

double largest(std::span<const double> values) {
  const std::vector<double> kept = without_nan(values);
  return kept.empty() ? undefined : *std::ranges::max_element(kept);
}

}  // namespace kappabench
