#include "schemes/segments/trigonometric.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kappabench {

TrigonometricSegment::TrigonometricSegment(const std::array<Vec2, 5>& control_points)
    : control_points_(control_points) {}

namespace {

using std::numbers::pi;

/// A scalar function of t and its first four derivatives.
using Derivatives = std::array<double, max_jet_order + 1>;

/// Leibniz' rule.
Derivatives product(const Derivatives& f, const Derivatives& g) {
  return {f[0] * g[0], f[1] * g[0] + f[0] * g[1], f[2] * g[0] + 2.0 * f[1] * g[1] + f[0] * g[2],
          f[3] * g[0] + 3.0 * (f[2] * g[1] + f[1] * g[2]) + f[0] * g[3],
          f[4] * g[0] + 4.0 * (f[3] * g[1] + f[1] * g[3]) + 6.0 * f[2] * g[2] + f[0] * g[4]};
}

}  // namespace

Jet TrigonometricSegment::jet(double t, int order) const {
  const double w1 = pi / 2.0;
  const double w2 = w1 * w1, w3 = w2 * w1, w4 = w2 * w2;
  const double S = std::sin(w1 * t), C = std::cos(w1 * t);
  // 1 - sin x and 1 - cos x without cancellation: 2 sin^2 of half the angle from where they vanish.
  const double half_u = std::sin(w1 * (1.0 - t) / 2.0), half_w = std::sin(w1 * t / 2.0);
  const Derivatives u{2.0 * half_u * half_u, -w1 * C, w2 * S, w3 * C, -w4 * S};
  const Derivatives w{2.0 * half_w * half_w, w1 * S, w2 * C, -w3 * S, -w4 * C};
  // v = S + C - 1 = 2 sin(x/2) (cos(x/2) - sin(x/2)) with x = pi t / 2.
  const double v0 = 2.0 * half_w * (std::cos(w1 * t / 2.0) - half_w);
  const Derivatives v{v0, w1 * (C - S), -w2 * (S + C), w3 * (S - C), w4 * (S + C)};

  // Miura 2022, Eq. (16): the blending functions u^2, 2uv, 4uw, 2vw, w^2 sum to one.
  const std::array<Derivatives, 5> basis{product(u, u), product(u, v), product(u, w), product(v, w), product(w, w)};
  constexpr std::array<double, 5> binomial{1.0, 2.0, 4.0, 2.0, 1.0};
  Jet jet;
  for (std::size_t r = 0; r <= static_cast<std::size_t>(order); ++r) {
    jet.d[r] = Vec2::Zero();
    for (std::size_t j = 0; j < basis.size(); ++j) jet.d[r] += binomial[j] * basis[j][r] * control_points_[j];
  }
  return jet;
}

ExactForm TrigonometricSegment::exact() const { return TrigonometricForm{control_points_}; }

SegmentPtr TrigonometricSegment::placed(const Placement& placement) const {
  auto points = control_points_;
  std::ranges::transform(points, points.begin(), placement);
  return std::make_shared<TrigonometricSegment>(points);
}

}  // namespace kappabench
