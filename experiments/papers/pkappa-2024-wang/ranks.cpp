#include "experiments/papers/pkappa-2024-wang/ranks.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/statistics.hpp"

namespace kappabench::wang {

namespace {

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> found;
  for (const double v : values) {
    const auto below = std::ranges::count_if(values, [v](double other) { return other < v; });
    const auto equal = std::ranges::count(values, v);
    found.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal - 1));
  }
  return found;
}

}  // namespace

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto has_missing = [](const auto& values) {
    return std::ranges::any_of(values, [](double v) { return std::isnan(v); });
  };
  if (a.size() != b.size() || a.size() < 3 || has_missing(a) || has_missing(b)) return undefined;
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const double middle = 0.5 * static_cast<double>(a.size() - 1);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (ra[i] - middle) * (rb[i] - middle);
    aa += (ra[i] - middle) * (ra[i] - middle);
    bb += (rb[i] - middle) * (rb[i] - middle);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace kappabench::wang
