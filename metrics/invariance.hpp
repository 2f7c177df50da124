#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

/// Is the curve the same when the points are moved, turned, mirrored, listed the other way round, or joined by one that
/// is on the curve already? And how far does it jump for a change in the ninth digit?
[[nodiscard]] Metric invariance_metric();

/// Distance of the scheme's curve through the corners of a regular polygon from the circle through them. It does not
/// depend on the input.
[[nodiscard]] Metric roundness_metric();

}  // namespace kappabench
