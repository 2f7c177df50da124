#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

/// How far each point is, along the curve, from the nearest extremum of curvature.
[[nodiscard]] Metric extremum_offset_metric();

}  // namespace kappabench
