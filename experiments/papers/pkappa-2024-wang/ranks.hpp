#pragma once

#include <vector>

namespace kappabench::wang {

/// Spearman's rank correlation; equal values share their ranks. NaN for fewer than three pairs, constant or missing
/// values.
[[nodiscard]] double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace kappabench::wang
