#pragma once

#include <algorithm>
#include <limits>
#include <span>

namespace kappabench {

inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Arithmetic mean; NaN of nothing.
[[nodiscard]] inline double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return values.empty() ? undefined : sum / static_cast<double>(values.size());
}

/// Largest value; NaN of nothing.
[[nodiscard]] inline double max_of(std::span<const double> values) {
  return values.empty() ? undefined : *std::max_element(values.begin(), values.end());
}

}  // namespace kappabench
