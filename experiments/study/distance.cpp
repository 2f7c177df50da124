#include "experiments/study/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kappabench::study {

namespace {

/// How many spans away from `point` the span number `k` lies: 1 for the two beside it.
int distance_in_spans(std::span<const Span> spans, int k, int point, bool closed) {
  const int n = static_cast<int>(spans.size());
  int best = std::numeric_limits<int>::max();
  for (int j = 0; j < n; ++j) {
    if (spans[static_cast<std::size_t>(j)].to != point) continue;
    // Span j ends at the point, span j + 1 starts there.
    const int before = j - k, after = k - j - 1;
    if (before >= 0) best = std::min(best, before + 1);
    if (after >= 0) best = std::min(best, after + 1);
    if (closed) best = std::min({best, (before + n) % n + 1, (after + n) % n + 1});
  }
  return best;
}

}  // namespace

std::vector<double> largest_by_distance(std::span<const Span> spans, std::span<const double> deviations, int point,
                                        bool closed, int farthest) {
  std::vector<double> found(static_cast<std::size_t>(farthest), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const int distance = distance_in_spans(spans, static_cast<int>(k), point, closed);
    if (distance > farthest) continue;
    double& largest = found[static_cast<std::size_t>(distance) - 1];
    largest = std::isnan(largest) ? deviations[k] : std::max(largest, deviations[k]);
  }
  return found;
}

}  // namespace kappabench::study
