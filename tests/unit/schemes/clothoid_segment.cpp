// Fresnel integrals and clothoids against quadrature in 34-digit arithmetic, taken on the same double-precision data.
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/numerics/fresnel.hpp"
#include "schemes/segments/clothoid.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

using Real = boost::multiprecision::cpp_bin_float_quad;
using Complex = std::complex<double>;

struct Reference {
  Real re, im;
};

/// Integral of exp(i phase(u)) du over [0, 1] by 20-point Gauss-Legendre on panels of about 2 radians.
template <class Phase>
Reference reference(const Phase& phase, double radians) {
  using Rule = boost::math::quadrature::gauss<Real, 20>;
  const int panels = 1 + static_cast<int>(radians / 2.0);
  Reference sum{0, 0};
  for (int k = 0; k < panels; ++k) {
    const Real half = Real(1) / (2 * panels), middle = Real(2 * k + 1) * half;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      for (const int side : {-1, 1}) {
        const Real p = phase(Real(middle + side * half * Rule::abscissa()[i]));
        sum.re += half * Rule::weights()[i] * cos(p);
        sum.im += half * Rule::weights()[i] * sin(p);
      }
  }
  return sum;
}

double error(const Complex& value, const Reference& exact) {
  return static_cast<double>(hypot(Real(value.real()) - exact.re, Real(value.imag()) - exact.im));
}

Reference integral(double b, double a) {
  return reference([&](const Real& u) { return (Real(b) + Real(a) * u / 2) * u; }, std::abs(b) + std::abs(a));
}

double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; }

}  // namespace

TEST_CASE("Fresnel integrals are accurate to 1e-15") {
  for (const double z : {0.0, 1e-12, 1e-3, 0.2, 0.5, 0.9, 1.3, 1.7, 2.0, 3.1, 4.7, 8.3, 12.5}) {
    INFO("z = " << z);
    const Real zz = z, half_pi = boost::math::constants::half_pi<Real>();
    Reference exact = reference([&](const Real& u) { return Real(half_pi * zz * zz * u * u); }, 3.2 * z * z);
    exact.re *= zz;
    exact.im *= zz;
    CHECK(error(fresnel(z), exact) <= 1e-15);
    CHECK(fresnel(-z) == -fresnel(z));
  }
}

namespace {

void check_integral(double b, double a) {
  INFO("b = " << b << ", a = " << a);
  const Reference exact = integral(b, a);
  CHECK(error(clothoid_integral(b, a), exact) <= 1e-14);
  CHECK(error(clothoid_moments(0.0, b, a)[0], exact) <= 1e-14);
}

}  // namespace

TEST_CASE("the integral of a clothoid is accurate to 1e-14") {
  std::mt19937_64 generator(1);
  for (const double size : {1e-9, 1e-3, 1.0, 5.0, 12.0, 60.0})
    for (int i = 0; i < 6; ++i) check_integral(size * uniform(generator), 2.0 * size * uniform(generator));
}

TEST_CASE("the same for curvature rates down to nothing") {
  for (const double b : {0.0, 1e-8, 0.7, 6.5, -40.0})
    for (const double a : {0.0, 1e-300, -1e-25, 1e-19, -1e-15, 1e-12, 1e-8, -1e-4}) check_integral(b, a);
}

TEST_CASE("the same on both sides of every switch of method") {
  for (const double side : {1.0 - 1e-15, 1.0 + 1e-15}) {
    check_integral(6.0 * side, 0.0);
    check_integral(0.0, 12.0 * side);
    check_integral(40.0, 1e-20 * side);
    check_integral(-30.0, 30.0 * side);  // the inflection at the end
  }
}

TEST_CASE("the same for long arcs") {
  for (const auto& [b, a] : {std::pair{0.0, 400.0}, {-140.0, 280.0}, {200.0, -260.0}, {180.0, 1e-3}})
    check_integral(b, a);
}

TEST_CASE("moments of a clothoid are the derivatives of its end") {
  const double heading = 0.4, b = 1.7, a = -3.1;
  const auto moments = clothoid_moments(heading, b, a);
  for (const int k : {0, 1, 2}) {
    const auto& value = moments[static_cast<std::size_t>(k)];
    Real re = 0, im = 0;
    using Rule = boost::math::quadrature::gauss<Real, 20>;
    for (int panel = 0; panel < 4; ++panel)
      for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
        for (const int side : {-1, 1}) {
          const Real u = Real(2 * panel + 1) / 8 + side * Rule::abscissa()[i] / 8;
          const Real p = Real(heading) + (Real(b) + Real(a) * u / 2) * u, weight = Rule::weights()[i] / 8 * pow(u, k);
          re += weight * cos(p);
          im += weight * sin(p);
        }
    CHECK(error(value, {re, im}) <= 1e-15);
  }
}

TEST_CASE("jets of a clothoid: arc length, curvature and its rate are the defining numbers") {
  const ClothoidForm form{Vec2(1.0, -2.0), 0.7, 0.8, -0.9, 3.0};
  const ClothoidSegment segment(form);
  CHECK(segment.jet(0.0, 0).position() == form.start);
  for (const double t : {0.0, 0.2, 0.5, 1.0}) {
    const Jet jet = segment.jet(t, 4);
    const double s = t * form.length;
    CHECK(speed(jet) == Approx(form.length).epsilon(1e-15));
    CHECK(curvature(jet) == Approx(form.curvature + form.curvature_rate * s).epsilon(1e-14));
    CHECK(curvature_derivative(jet) == Approx(form.curvature_rate).epsilon(1e-13));
    CHECK(std::abs(curvature_second_derivative(jet)) < 1e-13);
    // The position's own derivative, by a difference that is exact to h^4.
    const double h = 1e-3;
    const auto p = [&](double u) { return segment.jet(u, 0).position(); };
    const Vec2 difference = (8.0 * (p(t + h) - p(t - h)) - (p(t + 2 * h) - p(t - 2 * h))) / (12.0 * h);
    CHECK((difference - jet.d[1]).norm() < 1e-9);
  }
  CHECK(std::get<ClothoidForm>(segment.exact()).curvature_rate == form.curvature_rate);
}

TEST_CASE("clothoids without curvature rate are circles, without curvature lines, and the change is smooth") {
  const double pi = std::numbers::pi;
  const ClothoidSegment circle({Vec2(1.0, 0.0), 0.5 * pi, 1.0, 0.0, 2.0 * pi});
  CHECK((circle.jet(0.25, 0).position() - Vec2(0.0, 1.0)).norm() < 1e-15);
  CHECK((circle.jet(1.0, 0).position() - Vec2(1.0, 0.0)).norm() < 2e-15);
  const ClothoidSegment line({Vec2(1.0, 2.0), std::atan2(4.0, 3.0), 0.0, 0.0, 10.0});
  CHECK((line.jet(0.5, 0).position() - Vec2(4.0, 6.0)).norm() < 2e-15);
  CHECK(curvature_extrema(line).vanishes);
  // End of a quarter circle with a rate that vanishes: nothing jumps.
  Vec2 before = ClothoidSegment({Vec2::Zero(), 0.0, 0.5 * pi, 1e-6, 1.0}).jet(1.0, 0).position();
  for (double rate = 1e-6; rate > 1e-30; rate *= 0.1) {
    const Vec2 at = ClothoidSegment({Vec2::Zero(), 0.0, 0.5 * pi, rate, 1.0}).jet(1.0, 0).position();
    CHECK((at - before).norm() <= 10.0 * rate + 1e-15);
    before = at;
  }
}
