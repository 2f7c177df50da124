// Miura 2022, Appendix C: which other three-point bases the method applies to. It needs end curvatures that are
// neither zero nor infinite, because the ratio lambda of a joint follows from them.

#include <functional>

#include "schemes/kappa/basis.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;

namespace {

/// First and second derivatives of b_0 and b_2 at one parameter; b_1 = 1 - b_0 - b_2.
struct EndDerivatives {
  double d0, d2, dd0, dd2;
};

/// Curvature of b_0 P_0 + b_1 P_1 + b_2 P_2.
double curvature_of(const EndDerivatives& b, const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const Vec2 first = b.d0 * (p0 - p1) + b.d2 * (p2 - p1), second = b.dd0 * (p0 - p1) + b.dd2 * (p2 - p1);
  return cross(first, second) / std::pow(first.norm(), 3);
}

const Vec2 p0(0, 0), p1(2, 1), p2(3, -1);

}  // namespace

TEST_CASE("C.2: the cubic alternative curve is the epsilon-kappa segment with alpha = 3 a", "[kappa]") {
  for (const double alpha : {2.0, 2.3, 2.7, 2.95}) {
    const kappa::CubicBasis basis(alpha / 3.0);
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      const double u = 1.0 - t;
      const kappa::Blend b = basis.blend(t);
      CHECK(b.b0 == Approx(u * u * (1.0 + (2.0 - alpha) * t)).margin(1e-15));
      CHECK(b.b1 == Approx(alpha * u * t).margin(1e-15));
      CHECK(b.b2 == Approx(t * t * (1.0 + (2.0 - alpha) * u)).margin(1e-15));
    }
    // Its end curvature, 2 (3 - alpha) det(r, s) / (alpha^2 |r|^3), vanishes at alpha = 3 and nowhere before.
    const Vec2 r = p1 - p0, s = p2 - p1;
    const double expected = 2.0 * (3.0 - alpha) * cross(r, s) / (alpha * alpha * std::pow(r.norm(), 3));
    const kappa::Pair legs = basis.legs(0.0);
    const Vec2 first = legs.first * r + legs.second * s, second = legs.dfirst * r + legs.dsecond * s;
    CHECK(cross(first, second) / std::pow(first.norm(), 3) == Approx(expected).epsilon(1e-13));
    CHECK(std::abs(expected) > 1e-3);
  }
}

TEST_CASE("C.2: for alpha > 3 a blending function is negative", "[kappa]") {
  const double alpha = 3.5, t = 0.9, u = 1.0 - t;
  CHECK(u * u * (1.0 + (2.0 - alpha) * t) < 0.0);
}

TEST_CASE("C.1: the degenerate C-Bezier curve has no end curvature", "[kappa]") {
  // Z_3 = (t - sin t) / (alpha - sin alpha): first and second derivative vanish at the start.
  for (const double alpha : {0.5, 1.5, 3.0}) {
    const double k = 1.0 / (alpha - std::sin(alpha));
    // b_2 = Z_3(t), b_0 = Z_3(alpha - t), at t = 0.
    const EndDerivatives start{-k * (1.0 - std::cos(alpha)), 0.0, k * std::sin(alpha), 0.0};
    CHECK(curvature_of(start, p0, p1, p2) == 0.0);
  }
}

TEST_CASE("C.3: the cubic trigonometric Bezier curve has no end curvature for any shape parameter", "[kappa]") {
  const double quarter = std::numbers::pi / 2.0;
  for (const double alpha : {-1.5, -1.0, 0.0, 0.5, 1.0}) {
    // b_0 = (1 - S)^2 (1 - alpha S), b_2 the same in C, derivatives by t at t = 0 (S = 0, C = 1).
    const double d0 = quarter * -(2.0 + alpha);
    const double dd0 = quarter * quarter * (2.0 + 4.0 * alpha);
    const EndDerivatives start{d0, 0.0, dd0, 0.0};
    CHECK(std::abs(curvature_of(start, p0, p1, p2)) < 1e-15);
    // The derivatives above against differences of the basis itself.
    const auto b0 = [&](double t) {
      const double s = std::sin(quarter * t);
      return (1.0 - s) * (1.0 - s) * (1.0 - alpha * s);
    };
    const auto b2 = [&](double t) {
      const double c = std::cos(quarter * t);
      return (1.0 - c) * (1.0 - c) * (1.0 - alpha * c);
    };
    const double h = 1e-4;
    CHECK((b0(h) - b0(-h)) / (2 * h) == Approx(d0).margin(1e-5));
    CHECK((b0(h) - 2.0 * b0(0.0) + b0(-h)) / (h * h) == Approx(dd0).margin(1e-4));
    CHECK((b2(h) - b2(-h)) / (2 * h) == Approx(0.0).margin(1e-5));
    CHECK((b2(h) - 2.0 * b2(0.0) + b2(-h)) / (h * h) == Approx(0.0).margin(1e-4));
  }
}

TEST_CASE("C.4: alpha-beta Bernstein functions have end curvature only as the plain quadratic", "[kappa]") {
  for (const double alpha : {2.5, 3.0, 4.0}) {
    const EndDerivatives start{-alpha, 0.0, alpha * (alpha - 1.0), 0.0};  // (1-t)^alpha, t^alpha at 0, alpha > 2
    CHECK(std::abs(curvature_of(start, p0, p1, p2)) < 1e-15);
  }
  const EndDerivatives quadratic{-2.0, 0.0, 2.0, 2.0};  // alpha = 2
  const kappa::CubicBasis kappa_curve(2.0 / 3.0);
  const kappa::Pair legs = kappa_curve.legs(0.0);
  const Vec2 r = p1 - p0, s = p2 - p1;
  const Vec2 first = legs.first * r + legs.second * s, second = legs.dfirst * r + legs.dsecond * s;
  CHECK(curvature_of(quadratic, p0, p1, p2) == Approx(cross(first, second) / std::pow(first.norm(), 3)).epsilon(1e-14));
}

TEST_CASE("trigonometric cubic Bernstein-like functions are the quadratic trigonometric basis with alpha = 2 a",
          "[kappa]") {
  for (const double a : {0.5, 0.7, 0.95}) {  // Eq. (29) against Eq. (17)
    const kappa::TrigonometricBasis basis(a);
    for (const double t : {0.0, 0.2, 0.5, 0.7, 1.0}) {
      const double angle = t * kappa::TrigonometricBasis::last, s = std::sin(angle), c = std::cos(angle);
      const double u = 1.0 - s, v = s + c - 1.0, w = 1.0 - c;
      const kappa::Blend b = basis.blend(angle);
      CHECK(b.b0 == Approx(u * u + 2.0 * u * v * (1.0 - a) + 2.0 * u * w * (1.0 - a)).margin(1e-15));
      CHECK(b.b1 == Approx(2.0 * u * v * a + 4.0 * u * w * a + 2.0 * v * w * a).margin(1e-15));
      CHECK(b.b2 == Approx(w * w + 2.0 * v * w * (1.0 - a) + 2.0 * u * w * (1.0 - a)).margin(1e-15));
    }
  }
}
