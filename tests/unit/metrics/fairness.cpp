#include <cmath>
#include <numbers>

#include "schemes/curve/arc_length.hpp"
#include "schemes/segments/clothoid.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"
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

TEST_CASE("what a near-cusp holds is seen", "[fairness]") {
  // c = 24 (u^2 / 2, e u + u^3 / 3), u = t - 1/2, e = 2^-20: the speed falls to 4e-6 of its mean, on a stretch as
  // narrow. Numbers of mpmath at 60 digits: quadrature of the formulas, split at powers of ten of the distance from u =
  // 0, and the angle of (u, e + u^2) at the inflections u = +-sqrt(e).
  const double e = 0x1p-20;
  const SegmentPtr segment = bezier({{3, -1 - 12 * e}, {-1, 1 - 4 * e}, {-1, -1 + 4 * e}, {3, 1 + 12 * e}});
  const Fit fit = fit_of(single(segment));
  CHECK(arc_length(*segment, 0.0, 1.0) == Approx(24 * 0.265028549103127615).epsilon(1e-13));
  // The hodograph is rounded to about 1e-16 of its size, which is 1e-10 of what it is at u = 0.
  CHECK(value(fit, "fairness", "bending_energy") == Approx(388535220842.949378).epsilon(1e-9));
  CHECK(value(fit, "fairness", "mvc_energy") == Approx(2.26235221483947325e34).epsilon(1e-9));
  CHECK(value(fit, "fairness", "total_turning") == Approx(4.06107843328097439).epsilon(1e-13));
}

TEST_CASE("total turning up to a cusp and from it", "[fairness]") {
  // The cubic of fpc through (0, 0), a cusp in (1.3, 1) and (2, 0). At 60 digits: the least speed is 3e-16, at
  // t = 0.573313..., and the angles are those from the end tangents to the second derivative there.
  const Fit fit = fit_of(single(bezier(
      {{0, 0}, {0x1.2ee1d3e916b1ep+1, 0x1.c9eb7fead82ep-1}, {0x1.bb556f8f1ea3cp-2, 0x1.b60c55cd0b605p+0}, {2, 0}})));
  CHECK(value(fit, "fairness", "total_turning") == Approx(1.9509041243773508738).epsilon(1e-13));
}

TEST_CASE("total turning of a clover with four cusps, at any size", "[fairness]") {
  // Each of the four equal leaves turns by 3 / 2 pi from cusp to cusp: no inflections, and cusps a right angle apart.
  Input clover;
  clover.closed = true;
  for (const auto& [x, y] : {std::pair{12, 0},
                             {42, 10},
                             {38, 42},
                             {10, 40},
                             {0, 12},
                             {-10, 40},
                             {-38, 42},
                             {-42, 10},
                             {-12, 0},
                             {-42, -10},
                             {-38, -42},
                             {-10, -40},
                             {0, -12},
                             {10, -40},
                             {38, -42},
                             {42, -10}}) {
    clover.points.emplace_back(x, y);
    clover.options.emplace_back();
    if (x * y == 0) clover.options.back().type = PointType::cusp;
  }
  for (const double scale : {1.0, 1e6, 1e-6}) {
    Input input = clover;
    for (Vec2& p : input.points) p *= scale;
    const Fit fit = scheme("fpc")->fit(input);
    REQUIRE(fit.curve);
    CHECK(value(fit, "fairness", "total_turning") == Approx(6 * std::numbers::pi).epsilon(1e-10));
  }
}

TEST_CASE("an end at rest: infinite energy where curvature diverges, none on a line", "[fairness]") {
  const Fit bent = fit_of(single(bezier({{0, 0}, {0, 0}, {1, 0}, {1, 1}})));
  CHECK(std::isinf(value(bent, "fairness", "bending_energy")));
  // It turns from along x to along y.
  CHECK(value(bent, "fairness", "total_turning") == Approx(0.5 * std::numbers::pi).epsilon(1e-13));
  const Fit line = fit_of(single(bezier({{0, 0}, {0, 0}, {1, 0}, {2, 0}})));
  CHECK(value(line, "fairness", "bending_energy") == 0.0);
}

TEST_CASE("curvature over arc length turns by its integral, however often around", "[fairness]") {
  // kappa = 40 (1 - 2 s) over a length of 1: 10 rad to the left, 10 rad to the right.
  const ClothoidForm form{.start = {0, 0}, .angle = 0.3, .curvature = 40, .curvature_rate = -80, .length = 1};
  const Fit fit = fit_of(single(std::make_shared<ClothoidSegment>(form)));
  CHECK(value(fit, "fairness", "total_turning") == Approx(20).epsilon(1e-13));
}
