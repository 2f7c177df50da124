#pragma once

#include <cmath>
#include <vector>

#include "experiments/study/rows.hpp"
#include "experiments/study/tally.hpp"

namespace kappabench::wang {

/// A number of the same curves got in two ways, curve by curve. Where one is missing (NaN) the curve does not count.
struct TwoWays {
  study::Tally first_lower, second_lower;
  std::vector<double> ratios;  ///< first over second

  /// A difference counts beyond the relative `margin`.
  explicit TwoWays(const std::vector<study::Pair>& pairs, double margin = 0.0) {
    for (const auto& [first, second] : pairs) {
      if (std::isnan(first) || std::isnan(second)) continue;
      first_lower.add(first < second * (1.0 - margin));
      second_lower.add(first > second * (1.0 + margin));
      ratios.push_back(first / second);
    }
  }
};

}  // namespace kappabench::wang
