#pragma once

#include <vector>

#include "metrics/metric.hpp"

namespace kappabench {

/// What happens at one joint. Derivative jumps are |difference| over the larger of the two sizes and 1e-3 of the mean
/// chord.
struct JointJump {
  Joint joint;
  double gap;                    ///< distance of the two ends over the mean chord
  double angle;                  ///< between the tangents, radians, 0 to pi
  double curvature;              ///< |k1 - k0| / max(|k0|, |k1|, 1 / length of the curve), 0 to 2
  double curvature_magnitude;    ///< the same for |k|
  double curvature_uncertainty;  ///< how much of the above two rounding of the coordinates alone can cause
  double first_derivative;
  double second_derivative;

  /// Does it meet what is claimed? gap <= 1e-9, angle <= 1e-7 rad, relative jumps of curvature and of
  /// derivatives <= 1e-6, each plus the uncertainty from the rounding of coordinates.
  [[nodiscard]] bool meets_claim() const;
};

[[nodiscard]] std::vector<JointJump> joint_jumps(const Curve& curve, double mean_chord);

/// Largest jumps over all joints, by what was claimed, and the number of joints that miss their claim.
[[nodiscard]] Metric continuity_metric();

}  // namespace kappabench
