#pragma once

#include <span>
#include <vector>

#include "metrics/correspondence.hpp"

namespace kappabench::study {

/// The largest of the spans' deviations at each distance 1 ... farthest from the point, in spans: those that meet at
/// the point are at distance 1. NaN where there is no span.
[[nodiscard]] std::vector<double> largest_by_distance(std::span<const Span> spans, std::span<const double> deviations,
                                                      int point, bool closed, int farthest);

}  // namespace kappabench::study
