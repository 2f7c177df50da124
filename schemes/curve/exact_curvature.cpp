#include "schemes/curve/exact_curvature.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/curve/elliptic_roots.hpp"
#include "schemes/curve/enclosed_curvature.hpp"
#include "schemes/curve/intrinsic_roots.hpp"
#include "schemes/curve/polygon_roots.hpp"
#include "schemes/curve/sampled_curvature.hpp"

namespace kappabench {
namespace {

constexpr double cusp_speed = 1e-8;  // over the mean speed

/// The parameter x of a reparametrised segment, taken back to t = x / (m (1 - x) + x).
double outer_parameter(const ReparametrizedForm& form, double x) { return x / (form.start_speed * (1.0 - x) + x); }

SignChanges changes_of(const Segment& segment, bool of_slope);

/// t rises with x: the changes are those of the other segment.
SignChanges reparametrized_sign_changes(const ReparametrizedForm& form, bool of_slope) {
  SignChanges result = changes_of(*form.of, of_slope);
  constexpr double slack = 0x1p-51;
  for (RootBracket& bracket : result.at)
    bracket = {std::max(0.0, outer_parameter(form, bracket.lo) - slack),
               std::min(1.0, outer_parameter(form, bracket.hi) + slack)};
  return result;
}

SignChanges changes_of(const Segment& segment, bool of_slope) {
  const ExactForm form = segment.exact();
  if (const auto polygon = control_polygon(form)) {
    return polygon->finite() ? polygon_sign_changes(*polygon, of_slope) : SignChanges{};
  }
  if (const auto* clothoid = std::get_if<ClothoidForm>(&form)) return clothoid_sign_changes(*clothoid, of_slope);
  if (const auto* intrinsic = std::get_if<IntrinsicForm>(&form)) return intrinsic_sign_changes(*intrinsic, of_slope);
  if (const auto* arc = std::get_if<EllipticArcForm>(&form)) return elliptic_sign_changes(*arc, of_slope);
  if (const auto* same = std::get_if<ReparametrizedForm>(&form)) return reparametrized_sign_changes(*same, of_slope);
  if (const auto proved = enclosed_sign_changes(segment, of_slope)) return *proved;
  return sampled_sign_changes(segment, of_slope);
}

/// Which of the places where the speed is least are cusps. The mean is one of samples, so that a speed too close to the
/// limit proves nothing.
Cusps slow_enough(const Segment& segment, const std::vector<double>& places, Certification known) {
  Cusps cusps{{}, known};
  if (places.empty()) return cusps;
  const double limit = cusp_speed * mean_speed(segment);
  for (const double t : places) {
    const double v = speed(segment.jet(t, 1));
    if (v <= limit) cusps.at.push_back(t);
    if (!(v <= 0.25 * limit || v >= 4.0 * limit)) cusps.certification = Certification::sampled;
  }
  return cusps;
}

std::vector<double> middles(const std::vector<RootBracket>& brackets) {
  std::vector<double> result;
  for (const RootBracket& bracket : brackets) result.push_back(bracket.mid());
  return result;
}

}  // namespace

SignChanges curvature_extrema(const Segment& segment) { return changes_of(segment, true); }

SignChanges inflections(const Segment& segment) { return changes_of(segment, false); }

Cusps find_cusps(const Segment& segment) {
  using enum Certification;
  const ExactForm form = segment.exact();
  if (const auto polygon = control_polygon(form)) {
    return polygon->finite() ? slow_enough(segment, middles(polygon_slow_places(*polygon)), exact) : Cusps{};
  }
  // Their speed is constant.
  if (std::holds_alternative<ClothoidForm>(form) || std::holds_alternative<IntrinsicForm>(form)) return {};
  if (const auto* arc = std::get_if<EllipticArcForm>(&form)) {
    const SignChanges slow = elliptic_slow_places(*arc);
    return slow_enough(segment, middles(slow.at), slow.certification);
  }
  if (const auto* same = std::get_if<ReparametrizedForm>(&form)) {
    Cusps cusps = find_cusps(*same->of);
    for (double& x : cusps.at) x = outer_parameter(*same, x);
    return cusps;
  }
  if (speed_stays_above(segment, 4.0 * cusp_speed * mean_speed(segment))) return {{}, enclosed};
  return slow_enough(segment, sampled_slow_places(segment), sampled);
}

std::vector<double> cusps(const Segment& segment) { return find_cusps(segment).at; }

}  // namespace kappabench
