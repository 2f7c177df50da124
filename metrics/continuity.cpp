#include "metrics/continuity.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/arc_map.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/joint.hpp"
#include "schemes/curve/tangents.hpp"

namespace kappabench {
namespace {

double relative_jump(const Vec2& a, const Vec2& b, double guard) {
  return (b - a).norm() / std::max({a.norm(), b.norm(), guard});
}

double finite(double curvature) { return std::isfinite(curvature) ? curvature : 0.0; }

JointJump jump_at(const Joint& joint, const JointSides& sides, double chord, double length) {
  const auto& [before, after] = sides;
  const double k0 = finite(before.curvature()), k1 = finite(after.curvature());
  const double larger = std::max(std::abs(k0), std::abs(k1)), scale = std::max(larger, 1.0 / length);
  const double guard = 1e-3 * chord;
  return {joint,
          (after.position - before.position).norm() / chord,
          std::abs(angle_between(before.tangent, after.tangent)),
          std::abs(k1 - k0) / scale,
          std::abs(std::abs(k1) - std::abs(k0)) / scale,
          finite(before.curvature_error() + after.curvature_error()) / scale,
          relative_jump(before.first, after.first, guard),
          relative_jump(before.second, after.second, guard),
          larger < scale,
          !miss_of(sides, joint.claimed, chord)};
}

}  // namespace

std::vector<JointJump> joint_jumps(const Curve& curve, const Input& input) {
  const double chord = mean_chord(input), known_to = rounding_of(input), length = ArcMap(curve).length();
  std::vector<JointJump> jumps;
  jumps.reserve(curve.joints().size());
  for (const Joint& joint : curve.joints()) {
    const JointSides sides = sides_of(curve.segment(joint.segment), curve.segment(curve.next(joint.segment)), known_to);
    jumps.push_back(jump_at(joint, sides, chord, length));
  }
  return jumps;
}

Metric continuity_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    using enum Continuity;
    const std::vector<JointJump> all = joint_jumps(*fit.curve, fit.input);
    const auto claimed = [&](std::initializer_list<Continuity> claims) {
      std::vector<JointJump> jumps;
      std::ranges::copy_if(all, std::back_inserter(jumps), [&](const JointJump& jump) {
        return std::ranges::find(claims, jump.joint.claimed) != claims.end();
      });
      return jumps;
    };
    const auto largest = [](const Column& column, const std::vector<JointJump>& jumps, double JointJump::*value,
                            Method method = Method::exact) {
      std::vector<double> values;
      values.reserve(jumps.size());
      for (const JointJump& jump : jumps) values.push_back(jump.*value);
      return column(kappabench::largest(values), method);
    };
    const auto of_curvature = [](const std::vector<JointJump>& jumps) {
      return std::ranges::any_of(jumps, &JointJump::over_length) ? Method::sampled : Method::exact;
    };
    const auto g2_or_c2 = claimed({g2, c2}), equal = claimed({g1_equal_magnitude});
    const auto violations = std::ranges::count_if(all, [](const JointJump& jump) { return !jump.meets_claim; });
    return std::vector<Measurement>{
        largest(column::continuity_position_gap, all, &JointJump::gap),
        largest(column::continuity_angle_jump, claimed({g1, g1_equal_magnitude, g2, c1, c2}), &JointJump::angle),
        largest(column::continuity_curvature_jump_g2, g2_or_c2, &JointJump::curvature, of_curvature(g2_or_c2)),
        largest(column::continuity_curvature_jump_equal_magnitude, equal, &JointJump::curvature_magnitude,
                of_curvature(equal)),
        largest(column::continuity_signed_jump_equal_magnitude, equal, &JointJump::curvature, of_curvature(equal)),
        largest(column::continuity_curvature_jump_all, all, &JointJump::curvature, of_curvature(all)),
        largest(column::continuity_first_derivative_jump, claimed({c1, c2}), &JointJump::first_derivative),
        largest(column::continuity_second_derivative_jump, claimed({c2}), &JointJump::second_derivative),
        column::continuity_violations(static_cast<double>(violations),
                                      of_curvature(claimed({g1_equal_magnitude, g2, c2})))};
  };
  using namespace column;
  return {.id = "continuity",
          .title = "Continuity at joints against the claim",
          .version = 3,
          .columns = {continuity_position_gap, continuity_angle_jump, continuity_curvature_jump_g2,
                      continuity_curvature_jump_equal_magnitude, continuity_signed_jump_equal_magnitude,
                      continuity_curvature_jump_all, continuity_first_derivative_jump,
                      continuity_second_derivative_jump, continuity_violations},
          .measure = measure};
}

}  // namespace kappabench
