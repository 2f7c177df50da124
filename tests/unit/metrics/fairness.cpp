#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

TEST_CASE("energies of a circle, at any size", "[fairness]") {
  for (const double r : {1e-3, 1.0, 250.0}) {
    const Fit fit = fit_of(circle(r));
    const double turn = 2 * std::numbers::pi;
    CHECK(value(fit, "fairness", "bending_energy") == Approx(turn * turn).epsilon(1e-12));
    CHECK(value(fit, "fairness", "mvc_energy") < 1e-15);
    CHECK(value(fit, "fairness", "curvature_variation") < 1e-11);
    CHECK(value(fit, "fairness", "total_turning") == Approx(turn).epsilon(1e-12));
    CHECK(value(fit, "fairness", "length_over_chords") == Approx(turn / (4 * std::sqrt(2.0))).epsilon(1e-12));
  }
}

TEST_CASE("energies of a parabola against closed forms", "[fairness]") {
  // y = x^2 on [-1, 1]: kappa = 2 / (1 + 4 x^2)^(3/2).
  const Fit fit = fit_of(single(bezier({{-1, 1}, {0, -1}, {1, 1}})));
  const double length = std::sqrt(5.0) + 0.5 * std::asinh(2.0);
  // Integral of 4 (1 + 4x^2)^(-5/2) dx = 4 [x / (3 q^3) + 2x / (3 q)], q^2 = 1 + 4x^2.
  const double q = std::sqrt(5.0);
  const double bending = 8 * (1 / (3 * q * q * q) + 2 / (3 * q));
  const double peak = 2.0;
  const double end = 2 / (5 * q);
  CHECK(value(fit, "fairness", "bending_energy") == Approx(bending * length).epsilon(1e-12));
  CHECK(value(fit, "fairness", "curvature_variation") == Approx(2 * (peak - end) * length).epsilon(1e-12));
  CHECK(value(fit, "fairness", "total_turning") == Approx(2 * std::atan(2.0)).epsilon(1e-12));
  // MVC: (d kappa / ds)^2 ds = (24 x / q^6)^2 q dx, summed on a fine grid.
  double mvc = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double x = 2 * (i + 0.5) / n - 1;
    mvc += 2.0 / n * 576 * x * x * std::pow(1 + 4 * x * x, -5.5);
  }
  CHECK(value(fit, "fairness", "mvc_energy") == Approx(mvc * length * length * length).epsilon(1e-8));
}

TEST_CASE("total turning of an S counts both ways; a cusp has infinite energy", "[fairness]") {
  const Fit s = fit_of(single(bezier({{0, 0}, {1, 1}, {2, -1}, {3, 0}})));
  // The tangent turns from 45 degrees to that of c'(1/2), along (2, -1), and back.
  CHECK(value(s, "fairness", "total_turning") == Approx(2 * (std::numbers::pi / 4 + std::atan(0.5))).epsilon(1e-10));
  const Fit cusp = fit_of(single(bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}})));
  CHECK(std::isinf(value(cusp, "fairness", "bending_energy")));
  CHECK(std::isinf(value(cusp, "fairness", "curvature_variation")));
  CHECK(std::isfinite(value(cusp, "fairness", "total_turning")));
}
