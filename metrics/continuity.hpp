#pragma once

#include <vector>

#include "metrics/metric.hpp"

namespace kappabench {

namespace column {
inline const Column continuity_position_gap{"continuity_position_gap", "1",
                                            "largest gap at a joint over the mean chord; NaN without such a joint"};
inline const Column continuity_angle_jump{
    "continuity_angle_jump", "rad",
    "largest angle between tangents, joints claimed G1 or better; NaN without such a joint"};
inline const Column continuity_curvature_jump_g2{
    "continuity_curvature_jump_g2", "1",
    "largest relative jump of curvature, joints claimed G2 or C2; NaN without such a joint"};
inline const Column continuity_curvature_jump_equal_magnitude{
    "continuity_curvature_jump_equal_magnitude", "1",
    "largest relative jump of |curvature|, joints claimed G1 with equal magnitude; NaN without such a joint"};
inline const Column continuity_signed_jump_equal_magnitude{
    "continuity_signed_jump_equal_magnitude", "1",
    "largest relative jump of curvature, joints claimed G1 with equal magnitude; NaN without such a joint"};
inline const Column continuity_curvature_jump_all{
    "continuity_curvature_jump_all", "1", "largest relative jump of curvature at any joint; NaN without such a joint"};
inline const Column continuity_first_derivative_jump{
    "continuity_first_derivative_jump", "1",
    "largest relative jump of c', joints claimed C1 or C2; NaN without such a joint"};
inline const Column continuity_second_derivative_jump{
    "continuity_second_derivative_jump", "1",
    "largest relative jump of c'', joints claimed C2; NaN without such a joint"};
inline const Column continuity_violations{"continuity_violations", "1", "number of joints that miss their claim"};
}  // namespace column

/// What happens at one joint. Derivative jumps are |difference| over the larger of the two sizes and 1e-3 of the mean
/// chord.
struct JointJump {
  Joint joint;
  double gap;                    ///< distance of the two ends over the mean chord
  double angle;                  ///< between the tangents, radians, 0 to pi
  double curvature;              ///< |k1 - k0| / max(|k0|, |k1|, 1 / length of the curve), 0 to 2
  double curvature_magnitude;    ///< the same for |k|
  double curvature_uncertainty;  ///< how much of the above two rounding of the coordinates alone explains
  double first_derivative;
  double second_derivative;
  bool over_length;  ///< the jumps of curvature are relative to 1 / length: as good as that quadrature, not exact
  bool meets_claim;  ///< judged as every fit is (schemes/curve/joint.hpp)
};

/// At every joint of a curve through the points of `input`, both in the drawing's own frame (schemes/api/frame.hpp).
[[nodiscard]] std::vector<JointJump> joint_jumps(const Curve& curve, const Input& input);

/// Largest jumps over all joints, by what was claimed, and the number of joints that miss their claim.
[[nodiscard]] Metric continuity_metric();

}  // namespace kappabench
