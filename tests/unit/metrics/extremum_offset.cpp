#include <cmath>

#include "schemes/segments/clothoid.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

TEST_CASE("a node at the vertex of a parabola has offset 0", "[offset]") {
  const Fit fit = fit_of(single(bezier({{-1, 1}, {0, -1}, {1, 1}}), 0.5));
  CHECK(value(fit, "extremum_offset", "extremum_offset_max") < 1e-14);
  CHECK(value(fit, "extremum_offset", "nodes_at_extremum") == 1.0);
  CHECK(value(fit, "extremum_offset", "nodes_at_curvature_minimum") == 0.0);
}

TEST_CASE("a node beside the vertex has its arc length as offset", "[offset]") {
  // y = x^2, node at x = 1/2, end nodes at x = -1 and 1.
  const Fit fit = fit_of(single(bezier({{-1, 1}, {0, -1}, {1, 1}}), 0.75));
  const double arc = 0.25 * std::sqrt(2.0) + 0.25 * std::asinh(1.0);
  const double chord = 0.5 * (std::hypot(1.5, 0.75) + std::hypot(0.5, 0.75));
  CHECK(value(fit, "extremum_offset", "extremum_offset_mean") == Approx(arc / chord).epsilon(1e-12));
  CHECK(value(fit, "extremum_offset", "nodes_at_extremum") == 0.0);
}

TEST_CASE("a node at a minimum of curvature is told apart", "[offset]") {
  // Gentle trigonometric segment (a = 0.55, turning 45 degrees): its middle is a minimum of |curvature|.
  const double h = std::sqrt(0.5);
  const double a = 0.55;
  for (const double mirror : {1.0, -1.0}) {
    const Vec2 c0(0, 0);
    const Vec2 c1(1, 0);
    const Vec2 c2(1 + h, mirror * h);
    const Vec2 middle = 0.5 * ((1 - a) * c0 + 2 * a * c1 + (1 - a) * c2);
    const auto segment = std::make_shared<TrigonometricSegment>(
        std::array<Vec2, 5>{c0, (1 - a) * c0 + a * c1, middle, a * c1 + (1 - a) * c2, c2});
    const Fit fit = fit_of(single(segment, 0.5));
    CHECK(value(fit, "extremum_offset", "nodes_at_extremum") == 1.0);
    CHECK(value(fit, "extremum_offset", "nodes_at_curvature_minimum") == 1.0);
  }
}

TEST_CASE("no extremum, no offset", "[offset]") {
  CHECK(std::isnan(value(fit_of(circle(1.0)), "extremum_offset", "extremum_offset_max")));
}

TEST_CASE("on a closed curve the way around the closure counts", "[offset]") {
  // A lens of two parabolas: four joints' worth of jumps at its two corners; node just after the closure.
  const Curve lens({bezier({{-1, 0}, {0, 1}, {1, 0}}), bezier({{1, 0}, {0, -1}, {-1, 0}})},
                   {{0, Continuity::g0}, {1, Continuity::g0}}, {{0, 0, 0.5}, {1, 1, 0.999}}, true);
  const Fit fit = fit_of(lens);
  // Node 1 is close to the corner at the closure, where curvature is least; node 0 at a vertex, where |curvature| is
  // largest.
  CHECK(value(fit, "extremum_offset", "extremum_offset_max") < 0.01);
  CHECK(value(fit, "extremum_offset", "nodes_at_extremum") == 0.5);
}

TEST_CASE("both passages of a loop have the chords of its point", "[offset]") {
  Input loops{{{0, 0}, {36, 34}, {60, 4}, {84, 34}, {120, 0}}, false, std::vector<PointOptions>(5), {}};
  for (const std::size_t i : {1U, 3U}) {
    loops.options[i].type = PointType::loop;
    loops.options[i].alpha = loops.options[i].beta = 0.36;
  }
  const Fit fit = scheme("fpc")->fit(loops);
  REQUIRE(fit.curve);
  // From an independent measurement of the curve as it is written out, to three digits.
  CHECK(value(fit, "extremum_offset", "extremum_offset_max") == Approx(0.657).margin(0.0005));
}

TEST_CASE("a node with a maximum on one side and a minimum on the other is at no minimum", "[offset]") {
  // Curvature rises to the joint, jumps down, and rises again; backwards and in a mirror the answer is the same.
  const auto arc = [](double curvature, double rate, const Vec2& start, double angle) {
    return std::make_shared<ClothoidSegment>(ClothoidForm{start, angle, curvature, rate, 1.0});
  };
  for (const double side : {1.0, -1.0}) {
    const SegmentPtr one = arc(side * 1.0, side * 1.0, {0, 0}, 0.0);
    const Jet end = one->jet(1.0, 1);
    const Curve saw({one, arc(side * 0.5, side * 1.0, end.position(), tangent_angle(end))}, {{0, Continuity::g1}},
                    {{0, 0, 0.0}, {1, 0, 1.0}, {2, 1, 1.0}}, false);
    CHECK(value(fit_of(saw), "extremum_offset", "nodes_at_extremum") == 1.0);
    CHECK(value(fit_of(saw), "extremum_offset", "nodes_at_curvature_minimum") == 0.0);
    // Falls to the joint and rises from it, without a jump.
    const SegmentPtr falling = arc(side * 2.0, -side * 1.0, {0, 0}, 0.0);
    const Jet middle = falling->jet(1.0, 1);
    const Curve valley({falling, arc(side * 1.0, side * 1.0, middle.position(), tangent_angle(middle))},
                       {{0, Continuity::g2}}, {{0, 0, 0.0}, {1, 0, 1.0}, {2, 1, 1.0}}, false);
    CHECK(value(fit_of(valley), "extremum_offset", "nodes_at_curvature_minimum") == 1.0);
  }
}
