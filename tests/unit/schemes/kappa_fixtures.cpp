// Numbers computed with 30 to 40 digits.

#include "schemes/kappa/basis.hpp"
#include "schemes/kappa/stationary_point.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// An open curve through three points is one segment with the outer points as ends.
struct OneSegment {
  double t;
  Vec2 middle;
  double at_point, at_start, at_end;
};

OneSegment through(const std::string& scheme, const Vec2& c0, const Vec2& p, const Vec2& c2) {
  const Fit result = fit(scheme, {.points = {c0, p, c2}, .closed = false, .options = {}, .ids = {}});
  REQUIRE(result.report.outcome == Outcome::converged);
  REQUIRE(result.curve->size() == 1);
  const Node node = inner_nodes(result).front();
  const Segment& segment = result.curve->segment(0);
  // The outer legs meet at the middle control point.
  const Jet start = segment.jet(0.0, 2), end = segment.jet(1.0, 2);
  const double along = cross(end.d[0] - start.d[0], end.d[1]) / cross(start.d[1], end.d[1]);
  return {node.t, start.d[0] + along * start.d[1], curvature(segment.jet(node.t, 2)), curvature(start), curvature(end)};
}

void check(const OneSegment& got, double t, const Vec2& middle, double at_point, double at_start, double at_end) {
  CHECK(got.t == Approx(t).epsilon(1e-13));
  CHECK((got.middle - middle).norm() < 1e-12);
  CHECK(got.at_point == Approx(at_point).epsilon(1e-12));
  CHECK(got.at_start == Approx(at_start).epsilon(1e-12));
  CHECK(got.at_end == Approx(at_end).epsilon(1e-12));
}

}  // namespace

TEST_CASE("one cubic segment: parameter of the point, control point and curvatures", "[kappa]") {
  check(through("ekappa:a=0.8", {0, 0}, {1, 2}, {4, 1}), 0.4490740574557016, {0.6249769629339773, 3.1034850128677},
        -1.069857074574223, -0.07740852103646356, -0.03904926613541278);
  check(through("kappa", {0, 0}, {1, 2}, {4, 1}), 0.4396682658277627, {0.4602354050045981, 3.666770611626633},
        -0.8652884719955543, -0.1407452125491159, -0.08160230989724963);
  check(through("ekappa:a=0.66666666666666674", {0, 0}, {1, 2}, {4, 1}), 0.4396682658277627,
        {0.4602354050045981, 3.666770611626633}, -0.8652884719955543, -0.1407452125491159, -0.08160230989724963);
}

TEST_CASE("one trigonometric segment: parameter of the point, control point and curvatures", "[kappa]") {
  check(through("ekappa-trig:a=0.5", {0, 0}, {1, 2}, {4, 1}), 0.4318176364749155,
        {0.2821112134071485, 4.379700706447645}, -0.7369808245000365, -0.2039028609485184, -0.1358904516890817);
}

TEST_CASE("a closed curve with a different a at each point", "[kappa]") {
  Input input{.points = {{0, 0}, {4, -1}, {5, 3}, {2, 5}, {-1, 3}}, .closed = true, .options = {}, .ids = {}};
  input.options.resize(5);
  const double a[] = {0.7, 0.8, 0.75, 0.9, 0.7};
  for (std::size_t i = 0; i < 5; ++i) input.options[i].a = a[i];
  const Vec2 joints[] = {{2.411923299374456, -1.089609644921588},
                         {4.881478251153201, 0.4453233522559079},
                         {2.638643207795726, 4.81864555707906},
                         {1.39980042701897, 4.854963659852565},
                         {-0.8205088974233549, 1.242726222391176}};
  const double t[] = {0.3773138852389508, 0.489606066571102, 0.4724795883083409, 0.5114446087028744,
                      0.6022441865033923};
  const double kappa[] = {0.3127029875154481, 0.892081679500935, 0.4843451470712992, 1.246639876965358,
                          0.5756770018681197};
  for (const char* scheme : {"ekappa", "ekappa:iteration=published,max_iterations=1000"}) {
    const Fit result = fit(scheme, input);
    REQUIRE(result.report.outcome == Outcome::converged);
    for (int i = 0; i < 5; ++i) {
      const Segment& segment = result.curve->segment(i);
      const Node node = result.curve->nodes()[static_cast<std::size_t>(i)];
      CHECK((segment.jet(1.0, 0).position() - joints[i]).norm() < 2e-11);
      CHECK(node.t == Approx(t[i]).epsilon(1e-11));
      CHECK(curvature(segment.jet(node.t, 2)) == Approx(kappa[i]).epsilon(1e-11));
      CHECK(result.curve->joints()[static_cast<std::size_t>(i)].claimed == Continuity::g2);
    }
  }
}

TEST_CASE("linear trigonometric segments with an acute turn have a curvature minimum inside", "[kappa]") {
  // Legs (2, 0) and (1, 1): Miura 2022, Eq. (25) with the square root that the print lacks.
  const kappa::TrigonometricBasis basis(0.5);
  const kappa::StationaryEquation<kappa::TrigonometricBasis, kappa::Velocity::of_legs> slope(basis, Vec2(2, 0),
                                                                                             Vec2(1, 1), 0.0);
  const double angle = 0.3524163823495667 * kappa::TrigonometricBasis::last;
  CHECK(std::abs(slope(angle).value) < 1e-14);
  CHECK(slope(angle - 0.01).value < 0.0);
  CHECK(slope(angle + 0.01).value > 0.0);

  const TrigonometricSegment segment({Vec2(0, 0), Vec2(1, 0), Vec2(1.75, 0.25), Vec2(2.5, 0.5), Vec2(3, 1)});
  CHECK(curvature(segment.jet(0.3524163823495667, 2)) == Approx(0.1669252677110946).epsilon(1e-13));
  CHECK(curvature(segment.jet(0.0, 2)) == Approx(0.25).epsilon(1e-13));
  CHECK(curvature(segment.jet(1.0, 2)) == Approx(0.7071067811865475).epsilon(1e-13));

  // Through the scheme: the point of that parameter is interpolated and the minimum is named.
  const Fit result =
      fit("ekappa-trig:a=0.5", {.points = {{0, 0}, segment.jet(0.3524163823495667, 0).position(), {3, 1}},
                                .closed = false,
                                .options = {},
                                .ids = {}});
  REQUIRE(result.report.outcome == Outcome::converged);
  CHECK(inner_nodes(result).front().t == Approx(0.3524163823495667).epsilon(1e-12));
  CHECK(inner_nodes(result).front().has("curvature_minimum"));
  CHECK(result.report.counters.at("curvature_minimum") == 1);
}

TEST_CASE("a symmetric trigonometric segment of small turn peaks at its ends", "[kappa]") {
  const double a = 0.55, half = std::numbers::pi / 8.0;  // unit legs, turning 45 degrees
  const Vec2 c0(-std::cos(half), -std::sin(half)), c1(0, 0), c2(std::cos(half), -std::sin(half));
  const TrigonometricSegment segment(
      {c0, (1 - a) * c0 + a * c1, 0.5 * (1 - a) * (c0 + c2) + a * c1, a * c1 + (1 - a) * c2, c2});
  CHECK(std::abs(curvature(segment.jet(0.0, 2))) == Approx(0.5259471926180932).epsilon(1e-13));
  CHECK(std::abs(curvature(segment.jet(0.25, 2))) == Approx(0.400157429385416).epsilon(1e-13));
  CHECK(std::abs(curvature(segment.jet(0.5, 2))) == Approx(0.3795169331786764).epsilon(1e-13));
  const Fit result =
      fit("ekappa-trig:a=0.55",
          {.points = {c0, segment.jet(0.5, 0).position(), c2}, .closed = false, .options = {}, .ids = {}});
  REQUIRE(result.report.outcome == Outcome::converged);
  CHECK(inner_nodes(result).front().t == Approx(0.5).margin(1e-12));
  CHECK(inner_nodes(result).front().has("curvature_minimum"));
}
