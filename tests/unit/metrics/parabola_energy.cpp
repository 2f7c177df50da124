#include "metrics/parabola_energy.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::vector<Vec2> quintic{{0, 0}, {1, 2}, {3, 3}, {5, 2.5}, {6, 1}, {6.5, -1}};

/// Energy of a given parabola on a fine trapezoidal grid: slow, simple, independent.
double energy_by_sampling(const Segment& segment, const Parabola& q, int n) {
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / n;
    const Jet jet = segment.jet(t, 2);
    const double miss = curvature(jet) - q(t);
    sum += (i == 0 || i == n ? 0.5 : 1.0) * miss * miss * speed(jet);
  }
  return sum / n;
}

}  // namespace

TEST_CASE("energy of a given parabola on the reference quintic", "[parabola]") {
  const double energy = parabola_energy(*bezier(quintic), {-0.2, 0.5, -0.4});
  CHECK(energy == Approx(0.375777495286077).epsilon(1e-14));
}

TEST_CASE("the best parabola has less energy than its neighbours and meets its vertex", "[parabola]") {
  const SegmentPtr segment = bezier(quintic);
  const ParabolaFit pinned = best_parabola(*segment, 0.6);
  const ParabolaFit free = best_parabola(*segment, std::nullopt);
  CHECK(pinned.parabola.a1 == Approx(-2 * 0.6 * pinned.parabola.a2).epsilon(1e-12));
  CHECK(pinned.energy == Approx(parabola_energy(*segment, pinned.parabola)).epsilon(1e-11));
  CHECK(free.energy == Approx(parabola_energy(*segment, free.parabola)).epsilon(1e-11));
  CHECK(free.energy < pinned.energy);
  CHECK(pinned.energy == Approx(energy_by_sampling(*segment, pinned.parabola, 20000)).epsilon(1e-6));
  for (const double step : {1e-3, -1e-3}) {
    Parabola q = pinned.parabola;
    q.a0 += step;
    CHECK(parabola_energy(*segment, q) > pinned.energy);
    q = pinned.parabola;
    q.a2 += step;
    q.a1 = -2 * 0.6 * q.a2;
    CHECK(parabola_energy(*segment, q) > pinned.energy);
    q = free.parabola;
    q.a1 += step;
    CHECK(parabola_energy(*segment, q) > free.energy);
  }
}

TEST_CASE("unweighted samples give the published least-squares start", "[parabola]") {
  const SegmentPtr segment = bezier(quintic);
  std::vector<CurvatureSample> samples;
  for (int j = 0; j < 100; ++j) {
    const double t = j / 99.0;
    samples.push_back({t, curvature(segment->jet(t, 2)), 1.0});
  }
  const Parabola q = fit_parabola(samples, 0.6).parabola;
  CHECK(q.a0 == Approx(-0.1674223029026363).epsilon(1e-12));
  CHECK(q.a1 == Approx(-0.4716996655586796).epsilon(1e-12));
  CHECK(q.a2 == Approx(0.393083054632233).epsilon(1e-12));
}

TEST_CASE("a circle has no energy; scale-free columns are scale-free", "[parabola]") {
  for (const char* variant : {"native", "native_free", "centred", "centred_free"}) {
    const std::string stem = std::string("parabola_energy_") + variant;
    CHECK(value(fit_of(circle(2.0)), "parabola_energy", stem + "_max") < 1e-25);
    std::vector<Vec2> large;
    for (const Vec2& p : quintic) large.push_back(8.0 * p);
    const double small_energy = value(fit_of(single(bezier(quintic), 0.6)), "parabola_energy", stem + "_scaled_mean");
    const double large_energy = value(fit_of(single(bezier(large), 0.6)), "parabola_energy", stem + "_scaled_mean");
    CHECK(small_energy > 0.0);
    CHECK(large_energy == Approx(small_energy).epsilon(1e-11));
  }
}

TEST_CASE("native is one piece a segment, with its vertex at the node", "[parabola]") {
  const Fit fit = fit_of(single(bezier(quintic), 0.6));
  const double expected = best_parabola(*bezier(quintic), 0.6).energy;
  CHECK(value(fit, "parabola_energy", "parabola_energy_native_mean") == Approx(expected).epsilon(1e-11));
  CHECK(value(fit, "parabola_energy", "parabola_energy_native_max") == Approx(expected).epsilon(1e-11));
}

TEST_CASE("the centred piece ends half way, and is the same for a curve cut differently", "[parabola]") {
  // A parabola y = x^2 as one segment and cut in two at its node.
  const Curve whole({bezier({{-1, 1}, {0, -1}, {1, 1}})}, {}, {{0, 0, 0.0}, {1, 0, 0.5}, {2, 0, 1.0}}, false);
  const Curve cut({bezier({{-1, 1}, {-0.5, 0}, {0, 0}}), bezier({{0, 0}, {0.5, 0}, {1, 1}})}, {{0, Continuity::c2}},
                  {{0, 0, 0.0}, {1, 0, 1.0}, {2, 1, 1.0}}, false);
  const char* column = "parabola_energy_centred_mean";
  const double energy = value(fit_of(whole), "parabola_energy", column);
  CHECK(energy > 0.0);
  CHECK(value(fit_of(cut), "parabola_energy", column) == Approx(energy).epsilon(1e-10));
  CHECK(std::isnan(value(fit_of(cut), "parabola_energy", "parabola_energy_native_mean")));

  // Independently: curvature 2 / (1 + 4 x^2)^(3/2), arc length by closed form, a fine grid, normal equations.
  const auto arc = [](double x) { return 0.5 * x * std::sqrt(1 + 4 * x * x) + 0.25 * std::asinh(2 * x); };
  const double half = arc(1.0);
  double x_end = 0.5;
  for (int i = 0; i < 60; ++i) x_end -= (arc(x_end) - 0.5 * half) / std::sqrt(1 + 4 * x_end * x_end);
  const int n = 20000;
  double m00 = 0, m01 = 0, m11 = 0, b0 = 0, b1 = 0, kk = 0;
  for (int i = 0; i < n; ++i) {
    const double x = x_end * (2 * (i + 0.5) / n - 1);
    const double w = 2 * x_end / n * std::sqrt(1 + 4 * x * x);
    const double u = arc(x) / half;
    const double k = 2 / std::pow(1 + 4 * x * x, 1.5);
    m00 += w;
    m01 += w * u * u;
    m11 += w * u * u * u * u;
    b0 += w * k;
    b1 += w * k * u * u;
    kk += w * k * k;
  }
  const double det = m00 * m11 - m01 * m01;
  const double c0 = (b0 * m11 - b1 * m01) / det;
  const double c1 = (m00 * b1 - m01 * b0) / det;
  CHECK(energy == Approx(kk - c0 * b0 - c1 * b1).epsilon(1e-5));
}

TEST_CASE("a cusp makes the energy infinite, a straight line makes it zero", "[parabola]") {
  const Fit cusp = fit_of(single(bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}})));
  CHECK(std::isinf(value(cusp, "parabola_energy", "parabola_energy_native_max")));
  CHECK(std::isinf(value(cusp, "parabola_energy", "parabola_energy_centred_max")));
  const Fit line = fit_of(single(bezier({{0, 0}, {1, 0.1}, {2, 0.2}, {3, 0.3}})));
  CHECK(value(line, "parabola_energy", "parabola_energy_native_max") < 1e-25);
}
