#include "metrics/continuity.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/arc_map.hpp"
#include "metrics/statistics.hpp"
#include "metrics/tangents.hpp"

namespace kappabench {
namespace {

constexpr double allowed_gap = 1e-9;
constexpr double allowed_angle = 1e-7;
constexpr double allowed_jump = 1e-6;

double finite_curvature(const Jet& jet) {
  const double kappa = curvature(jet);
  return std::isfinite(kappa) ? kappa : 0.0;
}

/// What an error of one unit in the last place of the coordinates, blown up by differentiation (degree 5: 5 in c', 20
/// in c''), does to curvature = c' x c'' / |c'|^3.
double curvature_rounding(const Jet& jet) {
  const double unit = 0x1p-52 * jet.position().cwiseAbs().maxCoeff();
  const double v = speed(jet);
  const double bend = jet.d[2].norm();
  return v > 0.0 ? unit * (20.0 * v + 20.0 * bend) / (v * v * v) : 0.0;
}

double relative_jump(const Vec2& a, const Vec2& b, double guard) {
  return (b - a).norm() / std::max({a.norm(), b.norm(), guard});
}

JointJump jump_at(const Curve& curve, const Joint& joint, double chord, double length) {
  const Segment& before = curve.segment(joint.segment);
  const Segment& after = curve.segment(curve.next(joint.segment));
  const Jet end = before.jet(1.0, 2);
  const Jet start = after.jet(0.0, 2);
  const double rest = 1e-10 * length / curve.size();
  const double angle =
      angle_between(unit_tangent(before, 1.0, Side::before, rest), unit_tangent(after, 0.0, Side::after, rest));
  const double k0 = finite_curvature(end);
  const double k1 = finite_curvature(start);
  const double larger = std::max(std::abs(k0), std::abs(k1)), scale = std::max(larger, 1.0 / length);
  const double guard = 1e-3 * chord;
  return {joint,
          (start.position() - end.position()).norm() / chord,
          std::abs(angle),
          std::abs(k1 - k0) / scale,
          std::abs(std::abs(k1) - std::abs(k0)) / scale,
          (curvature_rounding(end) + curvature_rounding(start)) / scale,
          relative_jump(end.d[1], start.d[1], guard),
          relative_jump(end.d[2], start.d[2], guard),
          larger < scale};
}

}  // namespace

bool JointJump::meets_claim() const {
  if (!(gap <= allowed_gap)) return false;
  const Continuity claim = joint.claimed;
  if (claim == Continuity::g0) return true;
  if (!(angle <= allowed_angle)) return false;
  const double allowed_curvature = allowed_jump + curvature_uncertainty;
  switch (claim) {
    case Continuity::g1_equal_magnitude:
      return curvature_magnitude <= allowed_curvature;
    case Continuity::g2:
      return curvature <= allowed_curvature;
    case Continuity::c1:
      return first_derivative <= allowed_jump;
    case Continuity::c2:
      return first_derivative <= allowed_jump && second_derivative <= allowed_jump && curvature <= allowed_curvature;
    case Continuity::g0:
    case Continuity::g1:
      return true;
  }
  return false;
}

std::vector<JointJump> joint_jumps(const Curve& curve, double mean_chord) {
  const double length = ArcMap(curve).length();
  std::vector<JointJump> jumps;
  for (const Joint& joint : curve.joints()) jumps.push_back(jump_at(curve, joint, mean_chord, length));
  return jumps;
}

Metric continuity_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    using enum Continuity;
    const std::vector<JointJump> all = joint_jumps(*fit.curve, mean_chord(fit.input));
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
      for (const JointJump& jump : jumps) values.push_back(jump.*value);
      return column(kappabench::largest(values), method);
    };
    const auto of_curvature = [](const std::vector<JointJump>& jumps) {
      return std::ranges::any_of(jumps, &JointJump::over_length) ? Method::sampled : Method::exact;
    };
    const auto g2_or_c2 = claimed({g2, c2}), equal = claimed({g1_equal_magnitude});
    const auto violations = std::ranges::count_if(all, [](const JointJump& jump) { return !jump.meets_claim(); });
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
          .version = 2,
          .columns = {continuity_position_gap, continuity_angle_jump, continuity_curvature_jump_g2,
                      continuity_curvature_jump_equal_magnitude, continuity_signed_jump_equal_magnitude,
                      continuity_curvature_jump_all, continuity_first_derivative_jump,
                      continuity_second_derivative_jump, continuity_violations},
          .measure = measure};
}

}  // namespace kappabench
