// Hermite interpolation by one clothoid and by three.
#include "schemes/clothoid3/hermite.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/g1_clothoid.hpp"
#include "tests/catch.hpp"

using namespace kappabench;
using namespace kappabench::clothoid3;

namespace {

using std::numbers::pi;

double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; }

double end_heading(const ClothoidForm& c) {
  return c.angle + (c.curvature + 0.5 * c.curvature_rate * c.length) * c.length;
}
double end_curvature(const ClothoidForm& c) { return c.curvature + c.curvature_rate * c.length; }
Vec2 end_point(const ClothoidForm& c) { return ClothoidSegment(c).jet(1.0, 0).position(); }
double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * pi)); }

}  // namespace

TEST_CASE("G1 clothoids of known curvature and length") {
  // 40-digit values for chord 1, the start tangent turned by theta_e from the chord and the end by theta_d from the
  // start.
  struct Known {
    double theta_e, theta_d, curvature0, curvature1, length;
  };
  for (const Known& k : {Known{0.4, 0.0, 2.358321172971322, -2.358321172971322, 1.01611592013541},
                         Known{0.4, 0.2, 1.976110898453501, -1.580345384954768, 1.010699483297147},
                         Known{-0.3, 0.9, -3.220806834840579, 4.870202990040898, 1.091308473300879},
                         Known{pi / 9.0, pi / 3.0, 0.01865202158062864, 1.975653886983914, 1.050187482972808}}) {
    const auto c = g1_clothoid({0, 0}, -k.theta_e, {1, 0}, k.theta_d - k.theta_e);
    REQUIRE(c.has_value());
    CHECK(c->curvature == Approx(k.curvature0).epsilon(1e-13).margin(1e-14));
    CHECK(end_curvature(*c) == Approx(k.curvature1).epsilon(1e-13));
    CHECK(c->length == Approx(k.length).epsilon(1e-14));
  }
}

TEST_CASE("a G1 clothoid is found for every pair of headings, and ends where it should") {
  for (int i = -24; i <= 24; ++i)
    for (int j = -24; j <= 24; ++j) {
      const Vec2 from(3.0, 1.0), to(5.0, 1.0);
      const double start = i * pi / 24.0, end = j * pi / 24.0;
      const auto c = g1_clothoid(from, start, to, end);
      INFO("headings " << i << " and " << j << " times pi / 24");
      REQUIRE(c.has_value());
      CHECK((end_point(*c) - to).norm() <= 1e-13 * c->length);
      CHECK(angle_between(end_heading(*c), end) < 1e-13);
    }
}

TEST_CASE("three arcs meet points, headings and curvatures, and each other") {
  std::mt19937_64 generator(2);
  for (const double largest : {1e-9, 0.3, 2.0, 20.0, 1e4})
    for (int i = 0; i < 200; ++i) {
      const CurveElement from{Vec2(1.0, 2.0), pi * uniform(generator), largest * uniform(generator)};
      const CurveElement to{Vec2(1.0 + 2.0 * uniform(generator), 5.0), pi * uniform(generator),
                            largest * uniform(generator)};
      INFO("curvatures up to " << largest << ", case " << i);
      const auto found = three_arcs(from, to);
      REQUIRE(found.has_value());
      CHECK(found->residual < 1e-13);
      CHECK(found->iterations <= 10);
      const auto& [a, b, c] = found->arcs;
      double length = 0.0;
      for (const ClothoidForm& arc : found->arcs) {
        CHECK(arc.length > 0.0);
        length += arc.length;
      }
      CHECK(a.start == from.point);
      CHECK(a.curvature == Approx(from.curvature).epsilon(1e-14));
      CHECK((end_point(c) - to.point).norm() < 1e-14 * length + 2e-15);
      CHECK(angle_between(a.angle, from.heading) < 1e-14);
      CHECK(angle_between(end_heading(c), to.heading) < 1e-12);
      CHECK(end_curvature(c) == Approx(to.curvature).epsilon(1e-12).margin(1e-13));
      CHECK((end_point(a) - b.start).norm() < 1e-14);
      CHECK((end_point(b) - c.start).norm() < 1e-13 * length);
      CHECK(angle_between(end_heading(a), b.angle) < 1e-12);
      CHECK(angle_between(end_heading(b), c.angle) < 1e-12);
      const double scale = largest + std::abs(b.curvature) + std::abs(c.curvature) + 1.0 / length;
      CHECK(std::abs(end_curvature(a) - b.curvature) < 1e-13 * scale);
      CHECK(std::abs(end_curvature(b) - c.curvature) < 1e-13 * scale);
    }
}

TEST_CASE("three arcs on a circle are the circle, on a line the line") {
  const auto circle = three_arcs({Vec2(1, 0), 0.5 * pi, 1.0}, {Vec2(0, 1), pi, 1.0});
  REQUIRE(circle.has_value());
  for (const ClothoidForm& arc : circle->arcs)
    for (const double t : {0.0, 0.5, 1.0}) CHECK(ClothoidSegment(arc).jet(t, 0).position().norm() == Approx(1.0));
  const auto line = three_arcs({Vec2(0, 0), 0.0, 0.0}, {Vec2(2, 0), 0.0, 0.0});
  REQUIRE(line.has_value());
  for (const ClothoidForm& arc : line->arcs) CHECK(std::abs(arc.curvature) + std::abs(arc.curvature_rate) < 1e-14);
}

TEST_CASE("three arcs do not depend on the direction of travel") {
  const CurveElement from{Vec2(0, 0), 0.8, 1.5}, to{Vec2(3, 1), -1.1, -0.4};
  const auto there = three_arcs(from, to);
  const auto back =
      three_arcs({to.point, to.heading + pi, -to.curvature}, {from.point, from.heading + pi, -from.curvature});
  REQUIRE((there && back));
  for (const std::size_t i : {0U, 1U, 2U}) {
    const ClothoidForm &a = there->arcs[i], &b = back->arcs[2 - i];
    CHECK(a.length == Approx(b.length).epsilon(1e-12));
    CHECK((a.start - end_point(b)).norm() < 1e-12);
  }
}
