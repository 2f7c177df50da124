#pragma once

#include <vector>

#include "metrics/arc_map.hpp"
#include "metrics/metric.hpp"
#include "schemes/curve/certification.hpp"

namespace kappabench {

namespace column {
inline const Column inflections{"inflections", "1", "sign changes of curvature"};
inline const Column inflections_at_nodes{"inflections_at_nodes", "1",
                                         "sign changes of curvature within 1e-6 mean chord of a node"};
inline const Column inflections_at_joints{"inflections_at_joints", "1",
                                          "sign changes of curvature, at a joint that is no node"};
inline const Column cusps{"cusps", "1", "reversals of direction"};
inline const Column cusps_at_nodes{"cusps_at_nodes", "1", "reversals of direction within 1e-6 mean chord of a node"};
inline const Column cusps_at_joints{"cusps_at_joints", "1", "reversals of direction, at a joint that is no node"};
inline const Column loops{"loops", "1", "self-intersections; NaN if stretches of the curve coincide"};
inline const Column loops_at_nodes{"loops_at_nodes", "1", "self-intersections within 1e-6 mean chord of a node"};
inline const Column loops_at_joints{"loops_at_joints", "1", "self-intersections, at a joint that is no node"};
}  // namespace column

/// Places on a curve, and how their number is known.
struct Features {
  std::vector<double> positions;  ///< arc lengths from the start of the curve, ascending
  Certification certification = Certification::exact;
};

/// Where the curvature of the whole curve changes sign: inside segments and at joints. A change counts if the curvature
/// is more than rounding on both sides of it; a stretch of less between opposite signs counts once, at its end.
/// `known_to`, a length: what the coordinates of the drawing are rounded to (rounding_of).
[[nodiscard]] Features find_inflections(const Curve& curve, const ArcMap& arcs, double known_to);

/// Where the curve reverses its direction: cusps inside segments, and joints with an angle of pi but for 1e-6 or for
/// what rounding explains, up to 0.1.
[[nodiscard]] Features find_reversals(const Curve& curve, const ArcMap& arcs, double known_to);

/// Inflections, cusps and self-intersections, and whether they are at a node, at a joint, or elsewhere.
[[nodiscard]] Metric features_metric();

}  // namespace kappabench
