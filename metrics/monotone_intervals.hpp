#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

/// Into how many stretches of monotone curvature the curve falls: per segment, per piece around a node, and the
/// number of curvature extrema of the whole curve. Exact for segments whose d kappa / dt can be isolated.
[[nodiscard]] Metric monotone_intervals_metric();

}  // namespace kappabench
