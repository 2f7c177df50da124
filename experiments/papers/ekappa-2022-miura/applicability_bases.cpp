#include "experiments/papers/ekappa-2022-miura/applicability_bases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kappabench::miura {

namespace {

using std::numbers::pi;

/// f(w(t)) with w = 1 - cos(pi t / 2), from f and its derivatives with respect to w.
Blending of_cosine(double t, const std::function<Blending(double)>& f) {
  const double h = pi / 2.0, sine = std::sin(h * t), half = std::sin(h * t / 2.0);
  const double w = 2.0 * half * half, dw = h * sine, ddw = h * h * (1.0 - w);
  const Blending at = f(w);
  return {at.value, at.first * dw, at.second * dw * dw + at.first * ddw};
}

/// t^alpha; alpha >= 2, so that the second derivative exists at 0.
Blending power(double t, double alpha) {
  return {std::pow(t, alpha), alpha * std::pow(t, alpha - 1.0), alpha * (alpha - 1.0) * std::pow(t, alpha - 2.0)};
}

/// C.1: Z_3 = (x - sin x) / (alpha - sin alpha) with x = alpha t.
Blending c_bezier(double t, double alpha) {
  const double scale = 1.0 / (alpha - std::sin(alpha)), x = alpha * t, half = std::sin(x / 2.0);
  return {scale * (x - std::sin(x)), scale * alpha * 2.0 * half * half, scale * alpha * alpha * std::sin(x)};
}

/// C.2: t^2 (1 + (2 - alpha)(1 - t)).
Blending cubic_alternative(double t, double alpha) {
  const double q = 2.0 - alpha;
  return {t * t * (1.0 + q * (1.0 - t)), 2.0 * t * (1.0 + q) - 3.0 * q * t * t, 2.0 * (1.0 + q) - 6.0 * q * t};
}

/// C.3: (1 - C)^2 (1 - alpha C) with C = 1 - w.
Blending t_bezier(double t, double alpha) {
  return of_cosine(t, [alpha](double w) {
    const double q = 1.0 - alpha;  // w^2 (q + alpha w)
    return Blending{w * w * (q + alpha * w), 2.0 * q * w + 3.0 * alpha * w * w, 2.0 * q + 6.0 * alpha * w};
  });
}

/// C.4, the second basis, whose formula the paper leaves out: (1 - C)^alpha as in Zhu and Han 2015. Whatever
/// multiplies (1 - C)^2 there, both derivatives vanish at t = 0.
Blending quasi_cubic(double t, double alpha) {
  return of_cosine(t, [alpha](double w) { return power(w, alpha); });
}

/// Eq. (29): 1 + (alpha - 1) C^2 - alpha C = w (1 - m C), m = alpha - 1, with alpha = 2 a.
Blending trigonometric(double t, double a) {
  return of_cosine(t, [m = 2.0 * a - 1.0](double w) {
    return Blending{w * (1.0 - m + m * w), 1.0 - m + 2.0 * m * w, 2.0 * m};
  });
}

}  // namespace

const std::vector<DegenerateBasis>& degenerate_bases() {
  static const std::vector<DegenerateBasis> bases{
      {"c-bezier", "C-Bézier", "C-Bézier", "C.1, Fig. 14", {0.05, 0.5, 1.0, pi / 2.0, 2.0, 2.5, pi}, c_bezier},
      {"cubic-alternative",
       "cubic alternative",
       "cubic alternative",
       "C.2",
       {0.5, 1.0, 2.0, 2.4, 2.85, 3.0, 3.5, 4.0},
       cubic_alternative},
      {"t-bezier", "cubic trigonometric Bézier", "T-Bézier", "C.3", {-1.9, -1.0, -0.5, 0.0, 0.5, 1.0}, t_bezier},
      {"alpha-beta", "alpha-beta Bernstein-like", "alpha-beta", "C.4", {2.0, 2.25, 2.5, 3.0, 4.0, 6.0}, power},
      {"quasi-cubic", "quasi-cubic trigonometric", "quasi-cubic", "C.4", {2.0, 2.5, 3.0, 4.0}, quasi_cubic},
      {"bernstein",
       "constrained cubic Bernstein (Sect. 3)",
       "cubic Bernstein",
       "Eq. (1)",
       {2.0 / 3.0, 0.75, 0.85, 0.95},
       [](double t, double a) { return cubic_alternative(t, 3.0 * a); }},
      {"trigonometric",
       "quadratic trigonometric (Sect. 4)",
       "trigonometric",
       "Eqs. (17), (29)",
       {0.5, 0.6, 0.75, 0.9, 0.95},
       trigonometric}};
  return bases;
}

const DegenerateBasis& basis_named(std::string_view id) {
  return *std::ranges::find(degenerate_bases(), id, &DegenerateBasis::id);
}

std::array<Blending, 3> blending_functions(const DegenerateBasis& basis, double alpha, double t) {
  const Blending last = basis.last(t, alpha), mirrored = basis.last(1.0 - t, alpha);
  const Blending first{mirrored.value, -mirrored.first, mirrored.second};
  return {first, {1.0 - first.value - last.value, -first.first - last.first, -first.second - last.second}, last};
}

Jet degenerate_curve(const DegenerateBasis& basis, double alpha, const std::array<Vec2, 3>& control, double t) {
  const auto b = blending_functions(basis, alpha, t);
  const Vec2 back = control[0] - control[1], ahead = control[2] - control[1];
  Jet jet{};
  jet.d[0] = control[1] + b[0].value * back + b[2].value * ahead;
  jet.d[1] = b[0].first * back + b[2].first * ahead;
  jet.d[2] = b[0].second * back + b[2].second * ahead;
  return jet;
}

}  // namespace kappabench::miura
