#pragma once

#include <limits>
#include <span>
#include <vector>

namespace kappabench {

inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Of numbers some of which may be missing: NaNs are left out, and of nothing the answer is NaN.
[[nodiscard]] double mean(std::span<const double> values);
[[nodiscard]] double median(std::vector<double> values);
[[nodiscard]] double largest(std::span<const double> values);
/// The number below which this share of the values lies.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace kappabench
