#include "schemes/segments/clothoid.hpp"

#include <cmath>
#include <numbers>

#include "schemes/numerics/fresnel.hpp"
#include "schemes/numerics/gauss.hpp"

namespace kappabench {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int gauss_points = 20;
/// Radians of phase in one panel for which the rule is exact to rounding.
constexpr double phase_of_panel = 6.0;

Complex direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// a > 0 and the phase's stationary point -b / a not after the middle: with x = (b + a u) / sqrt(2 a) the phase is
/// x^2 - x_0^2, and the integral from x_0 to x_1 is a difference of tails.
Complex by_tails(double b, double a) {
  const double root = std::sqrt(2.0 * a);
  const double x0 = b / root, x1 = (b + a) / root;
  const Complex end = direction(b + 0.5 * a) * fresnel_tail(x1);
  // F(-x) = 1 - F(x) before the stationary point.
  const Complex start = x0 >= 0.0 ? fresnel_tail(x0) : direction(-x0 * x0) - fresnel_tail(-x0);
  return std::sqrt(2.0 * pi / a) * direction(pi / 4.0) * (start - end);
}

}  // namespace

Complex clothoid_integral(double b, double a) {
  if (std::abs(b) + 0.5 * std::abs(a) <= phase_of_panel) {
    Complex sum = 0.0;
    for_gauss_nodes<gauss_points>(0.0, 1.0,
                                  [&](double u, double weight) { sum += weight * direction((b + 0.5 * a * u) * u); });
    return sum;
  }
  // A circular arc: the phase of the curvature rate is below rounding.
  if (std::abs(a) < 1e-20) return direction(0.5 * b) * (std::sin(0.5 * b) / (0.5 * b));
  if (a < 0.0) return std::conj(clothoid_integral(-b, -a));
  if (b + a <= 0.0) return direction(b + 0.5 * a) * clothoid_integral(-(b + a), a);  // run backwards: u -> 1 - u
  return by_tails(b, a);
}

std::array<Complex, 3> clothoid_moments(double heading, double b, double a) {
  const int panels = 1 + static_cast<int>((std::abs(b) + 0.5 * std::abs(a)) / phase_of_panel);
  std::array<Complex, 3> moments{};
  for_composite_gauss_nodes<gauss_points>(panels, [&](double u, double weight) {
    const Complex value = weight * direction(heading + (b + 0.5 * a * u) * u);
    moments[0] += value;
    moments[1] += u * value;
    moments[2] += u * u * value;
  });
  return moments;
}

Vec2 clothoid_displacement(double angle, double curvature, double curvature_rate, double s) {
  const Complex d = s * direction(angle) * clothoid_integral(curvature * s, curvature_rate * s * s);
  return {d.real(), d.imag()};
}

Jet ClothoidSegment::jet(double t, int order) const {
  const double length = form_.length, s = length * t;
  const double kappa = form_.curvature + form_.curvature_rate * s;
  const double rate = form_.curvature_rate;
  const double heading = form_.angle + (form_.curvature + 0.5 * rate * s) * s;
  const Vec2 tangent(std::cos(heading), std::sin(heading));
  const Vec2 normal = left_normal(tangent);
  // d/ds of tangent is kappa normal, of normal -kappa tangent.
  Jet jet;
  jet.d[0] = form_.start + clothoid_displacement(form_.angle, form_.curvature, rate, s);
  const double l2 = length * length;
  if (order >= 1) jet.d[1] = length * tangent;
  if (order >= 2) jet.d[2] = l2 * kappa * normal;
  if (order >= 3) jet.d[3] = l2 * length * (rate * normal - kappa * kappa * tangent);
  if (order >= 4) jet.d[4] = -l2 * l2 * (3.0 * kappa * rate * tangent + kappa * kappa * kappa * normal);
  return jet;
}

SegmentPtr ClothoidSegment::placed(const Placement& placement) const {
  ClothoidForm form = form_;
  form.start = placement(form.start);
  form.curvature /= placement.scale;
  form.curvature_rate = form.curvature_rate / placement.scale / placement.scale;
  form.length *= placement.scale;
  return std::make_shared<ClothoidSegment>(std::move(form));
}

}  // namespace kappabench
