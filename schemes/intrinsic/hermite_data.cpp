#include "schemes/intrinsic/hermite_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "schemes/segments/intrinsic.hpp"

namespace kappabench::intrinsic {

namespace {

std::optional<double> times(const std::optional<double>& value, double factor) {
  return value ? std::optional(*value * factor) : std::nullopt;
}

/// In (-pi, pi].
double principal(double angle) {
  const double a = std::remainder(angle, 2.0 * std::numbers::pi);
  return a <= -std::numbers::pi ? std::numbers::pi : a;
}

}  // namespace

StandardData standard_form(const HermiteData& data) {
  const Vec2 chord = data.to.point - data.from.point;
  const double direction = std::atan2(chord.y(), chord.x()), length = chord.norm();
  const double chord_angle = principal(direction - data.from.heading);
  // A heading straight back is half a turn either way: the other way than at the start makes an S and not a full turn.
  const double end_angle = -principal(direction - data.to.heading);
  return {chord_angle, chord_angle + end_angle, times(data.from.curvature, length), times(data.to.curvature, length)};
}

IntrinsicForm form_of(const StandardCurve& curve, double angle) {
  return {Vec2::Zero(), angle, curve.length, curve.basis.degree, curve.basis.knots, curve.controls};
}

double largest_control(const StandardCurve& curve) {
  double largest = 0.0;
  for (const double k : curve.controls) largest = std::max(largest, std::abs(k));
  return largest;
}

StandardData mirrored(const StandardData& data) {
  return {-data.chord_angle, -data.turning, times(data.start_curvature, -1.0), times(data.end_curvature, -1.0)};
}

StandardCurve mirrored(StandardCurve curve) {
  for (double& k : curve.controls) k = -k;
  return curve;
}

StandardData reversed(const StandardData& data) {
  return {-data.end_angle(), -data.turning, times(data.end_curvature, -1.0), times(data.start_curvature, -1.0)};
}

StandardCurve reversed(StandardCurve curve) {
  std::ranges::reverse(curve.basis.knots);
  for (double& t : curve.basis.knots) t = 1.0 - t;
  std::ranges::reverse(curve.controls);
  return mirrored(std::move(curve));
}

IntrinsicForm placed(const StandardCurve& curve, const HermiteData& data) {
  const double chord = (data.to.point - data.from.point).norm();
  IntrinsicForm form{data.from.point,    data.from.heading, curve.length * chord,
                     curve.basis.degree, curve.basis.knots, curve.controls};
  for (double& k : form.control_curvatures) k /= chord;
  return form;
}

double gap(const StandardCurve& curve, const StandardData& data) {
  const IntrinsicSegment segment(form_of(curve, -data.chord_angle));
  const std::vector<double> integrals = basis_integrals(curve.basis);
  const double turning =
      curve.length * std::inner_product(integrals.begin(), integrals.end(), curve.controls.begin(), 0.0);
  return (segment.jet(1.0, 0).position() - Vec2::UnitX()).norm() + std::abs(turning - data.turning);
}

}  // namespace kappabench::intrinsic
