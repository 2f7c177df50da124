#include <cmath>
#include <numbers>

#include "schemes/clothoid3/hermite.hpp"
#include "schemes/segments/clothoid.hpp"

namespace kappabench::clothoid3 {

namespace {

using std::numbers::pi;

/// Im and Re of the clothoid's end for headings phi0 and phi1 against its chord: Bertolazzi and Frego 2015, g(A) and
/// h(A) with heading phi0 + (delta - A) u + A u^2. The end is on the chord iff g = 0.
struct End {
  double across, along, across_slope;
};

End end_of(double phi0, double delta, double A) {
  const auto moments = clothoid_moments(phi0, delta - A, 2.0 * A);
  return {moments[0].imag(), moments[0].real(), moments[2].real() - moments[1].real()};
}

/// Newton from A; the curve's shape factor A, or nullopt.
std::optional<double> root_from(double phi0, double delta, double A) {
  constexpr double rounding = 4e-16;
  End at = end_of(phi0, delta, A);
  for (int i = 0; i < 60 && std::abs(at.across) > rounding; ++i) {
    double step = -at.across / at.across_slope;
    if (!std::isfinite(step)) return std::nullopt;
    End next = end_of(phi0, delta, A + step);
    for (int halvings = 0; !(std::abs(next.across) < std::abs(at.across)) && halvings < 12; ++halvings) {
      step *= 0.5;
      next = end_of(phi0, delta, A + step);
    }
    if (!(std::abs(next.across) < std::abs(at.across))) break;
    A += step;
    at = next;
  }
  if (std::abs(at.across) <= 1e-12 && at.along > 0.0) return A;
  return std::nullopt;
}

}  // namespace

std::optional<ClothoidForm> g1_hermite(const CurveElement& from, const CurveElement& to) {
  const Vec2 chord = to.point - from.point;
  const double direction = std::atan2(chord.y(), chord.x());
  const double phi0 = std::remainder(from.heading - direction, 2.0 * pi);
  const double phi1 = std::remainder(to.heading - direction, 2.0 * pi);
  const double delta = phi1 - phi0;
  // A = 3 (phi0 + phi1) solves the equation to first order; it overshoots for large angles.
  for (const double factor : {3.0, 2.5, 2.0, 1.5, 1.0})
    if (const auto A = root_from(phi0, delta, factor * (phi0 + phi1))) {
      const double length = chord.norm() / end_of(phi0, delta, *A).along;
      return ClothoidForm{.start = from.point,
                          .angle = from.heading,
                          .curvature = (delta - *A) / length,
                          .curvature_rate = 2.0 * *A / (length * length),
                          .length = length};
    }
  return std::nullopt;
}

}  // namespace kappabench::clothoid3
