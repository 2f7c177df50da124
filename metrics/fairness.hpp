#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

/// The classical fairness energies, made free of scale by powers of the curve's length.
[[nodiscard]] Metric fairness_metric();

}  // namespace kappabench
