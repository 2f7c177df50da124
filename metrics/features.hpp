#pragma once

#include <vector>

#include "metrics/arc_map.hpp"
#include "metrics/metric.hpp"

namespace kappabench {

/// Where the curvature of the whole curve changes sign, as arc lengths from its start, ascending: inside segments
/// (certified where possible) and at joints. A straight stretch between opposite signs counts once, at its end; changes
/// closer than 1e-9 of the length cancel in pairs, as rounding at a joint makes them.
[[nodiscard]] std::vector<double> inflection_positions(const Curve& curve, const ArcMap& arcs);

/// Where the curve reverses its direction: cusps inside segments, and joints with an angle above pi - 1e-6.
[[nodiscard]] std::vector<double> cusp_positions(const Curve& curve, const ArcMap& arcs);

/// Inflections, cusps and self-intersections, and whether they are at a node, at a joint, or elsewhere.
[[nodiscard]] Metric features_metric();

}  // namespace kappabench
