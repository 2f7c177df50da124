#include "schemes/segments/g1_clothoid.hpp"

#include <cmath>
#include <numbers>

#include "schemes/segments/clothoid.hpp"

namespace kappabench {

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

/// Newton from A; the curve's shape factor A and the way along the chord for unit length, or nullopt.
struct Root {
  double A, along;
};
std::optional<Root> root_from(double phi0, double delta, double A) {
  constexpr double rounding = 4e-16, solved = 1e-12;
  End at = end_of(phi0, delta, A);
  for (int i = 0; i < 60 && std::abs(at.across) > rounding; ++i) {
    double step = -at.across / at.across_slope;
    if (!std::isfinite(step)) return std::nullopt;
    End next = end_of(phi0, delta, A + step);
    // A step that does not help a solved equation is rounding.
    const int most = std::abs(at.across) > solved ? 12 : 0;
    for (int halvings = 0; !(std::abs(next.across) < std::abs(at.across)) && halvings < most; ++halvings) {
      step *= 0.5;
      next = end_of(phi0, delta, A + step);
    }
    if (!(std::abs(next.across) < std::abs(at.across))) break;
    A += step;
    at = next;
  }
  if (std::abs(at.across) <= solved && at.along > 0.0) return Root{A, at.along};
  return std::nullopt;
}

}  // namespace

double G1Clothoid::turn() const {
  const double delta = end - start;
  // The curvature changes its sign inside iff |shape| > |delta|.
  return std::abs(shape) <= std::abs(delta) ? std::abs(delta)
                                            : 0.5 * (delta * delta / std::abs(shape) + std::abs(shape));
}

std::optional<G1Clothoid> g1_clothoid(double start, double end) {
  // A = 3 (phi0 + phi1) solves the equation to first order; it overshoots for large angles.
  for (const double factor : {3.0, 2.5, 2.0, 1.5, 1.0})
    if (const auto root = root_from(start, end - start, factor * (start + end)))
      return G1Clothoid{start, end, root->A, root->along};
  return std::nullopt;
}

std::optional<ClothoidForm> g1_clothoid(const Vec2& from, double start, const Vec2& to, double end) {
  const Vec2 chord = to - from;
  const double direction = std::atan2(chord.y(), chord.x());
  const auto seen = g1_clothoid(std::remainder(start - direction, 2.0 * pi), std::remainder(end - direction, 2.0 * pi));
  if (!seen) return std::nullopt;
  const double length = chord.norm() / seen->along;
  return ClothoidForm{.start = from,
                      .angle = start,
                      .curvature = (seen->end - seen->start - seen->shape) / length,
                      .curvature_rate = 2.0 * seen->shape / (length * length),
                      .length = length};
}

}  // namespace kappabench
