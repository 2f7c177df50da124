#pragma once

#include <array>
#include <complex>
#include <utility>

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// Integral of exp(i (b u + a u^2 / 2)) du from 0 to 1: where a clothoid of length 1 with the start heading 0, start
/// curvature b and curvature rate a ends.
///
/// Closed form through Fresnel integrals; where the clothoid turns by little, in which case their differences cancel,
/// 20-point Gauss-Legendre quadrature instead. Error below 1e-14 (README of this folder) for |b|, |a| up to 1e4, and
/// about that of the double-precision phases beyond.
[[nodiscard]] std::complex<double> clothoid_integral(double b, double a);

/// Integrals of u^k exp(i (heading + b u + a u^2 / 2)) du from 0 to 1 for k = 0, 1, 2: a clothoid's end and its
/// derivatives by b and a, for Newton iterations. Composite Gauss-Legendre quadrature, error below 1e-14; time grows
/// with |b| + |a|.
[[nodiscard]] std::array<std::complex<double>, 3> clothoid_moments(double heading, double b, double a);

/// From the start of the clothoid to the point at arc length `s`; negative s is before the start.
[[nodiscard]] Vec2 clothoid_displacement(double angle, double curvature, double curvature_rate, double s);

/// Curvature linear in arc length, s = length * t: straight lines and circular arcs included.
class ClothoidSegment final : public Segment {
 public:
  explicit ClothoidSegment(ClothoidForm form) : form_(std::move(form)) {}

  [[nodiscard]] const ClothoidForm& form() const { return form_; }

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override { return form_; }
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  ClothoidForm form_;
};

}  // namespace kappabench
