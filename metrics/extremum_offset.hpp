#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

namespace column {
inline const Column extremum_offset_mean{"extremum_offset_mean", "1",
                                         "mean arc length from a node to the nearest curvature extremum over the local "
                                         "chord; NaN without interior nodes or without extrema"};
inline const Column extremum_offset_max{"extremum_offset_max", "1", "the same, largest"};
inline const Column nodes_at_extremum{"nodes_at_extremum", "1",
                                      "fraction of the interior nodes within 1e-6 of the local chord; NaN without "
                                      "interior nodes or without extrema"};
inline const Column nodes_at_curvature_minimum{
    "nodes_at_curvature_minimum", "1",
    "number of these nodes where |curvature| has a local minimum and, on neither side, a maximum"};
}  // namespace column

/// How far each point is, along the curve, from the nearest extremum of curvature.
[[nodiscard]] Metric extremum_offset_metric();

}  // namespace kappabench
