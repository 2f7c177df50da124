// The scheme `intrinsic`: what is given is met, what is estimated keeps curvature monotone between points.
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/intrinsic/hermite_chain.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using Catch::Matchers::Contains;
using std::numbers::pi;
using test::scheme;

namespace {

Input walk(std::uint64_t seed, int points) {
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; };
  Input input;
  Vec2 at(0, 0);
  double heading = 0.0;
  for (int i = 0; i < points; ++i) {
    input.points.push_back(at);
    heading += uniform();
    at += (1.3 + uniform()) * Vec2(std::cos(heading), std::sin(heading));
  }
  return input;
}

Input ring(int points) {
  Input input{.closed = true};
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * pi * i / points;
    input.points.emplace_back(3.0 * std::cos(angle), 3.0 * std::sin(angle));
  }
  return input;
}

std::size_t extrema_inside(const Curve& curve) {
  std::size_t count = 0;
  for (const SegmentPtr& segment : curve.segments()) count += curvature_extrema(*segment).at.size();
  return count;
}

}  // namespace

TEST_CASE("intrinsic scheme: curvature is monotone between almost all points of random walks") {
  std::size_t spans = 0, not_monotone = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Fit fit = scheme("intrinsic")->fit(walk(seed, 20));
    INFO("seed " << seed);
    REQUIRE(fit.report.outcome == Outcome::converged);
    const auto with_extrema = static_cast<std::size_t>(fit.report.counters.at("spans_not_monotone"));
    CHECK(extrema_inside(*fit.curve) >= with_extrema);
    CHECK((extrema_inside(*fit.curve) == 0) == (with_extrema == 0));
    spans += 19;
    not_monotone += with_extrema;
  }
  CHECK(not_monotone <= spans / 20);
}

TEST_CASE("intrinsic scheme: relaxation of headings is what makes spans monotone") {
  std::size_t unrelaxed = 0, relaxed = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    unrelaxed += extrema_inside(*scheme("intrinsic:rounds=0")->fit(walk(seed, 20)).curve);
    relaxed += extrema_inside(*scheme("intrinsic")->fit(walk(seed, 20)).curve);
  }
  CHECK(relaxed * 5 < unrelaxed);
}

TEST_CASE("intrinsic scheme: points of a circle give the circle") {
  for (const char* const options : {"", ":continuity=g1", ":auto=false", ":curvature=circle"})
    for (const int n : {3, 4, 7, 24}) {
      INFO("intrinsic" << options << ", " << n << " points");
      const Fit fit = scheme(std::string("intrinsic") + options)->fit(ring(n));
      REQUIRE(fit.report.outcome == Outcome::converged);
      for (const SegmentPtr& segment : fit.curve->segments())
        for (const double t : {0.0, 0.3, 1.0}) {
          CHECK(segment->jet(t, 0).position().norm() == Approx(3.0).epsilon(1e-12));
          CHECK(curvature(segment->jet(t, 2)) == Approx(1.0 / 3.0).epsilon(1e-10));
        }
    }
}

TEST_CASE("intrinsic scheme: given tangents and curvatures are met") {
  Input input = walk(3, 8);
  input.options.resize(8);
  input.options[2].tangent = 0.7;
  input.options[5].curvature = 0.05;
  const Fit fit = scheme("intrinsic")->fit(input);
  REQUIRE(fit.curve);
  CHECK(tangent_angle(fit.curve->segment(2).jet(0.0, 1)) == Approx(0.7).epsilon(1e-12));
  CHECK(tangent_angle(fit.curve->segment(1).jet(1.0, 1)) == Approx(0.7).epsilon(1e-12));
  CHECK(curvature(fit.curve->segment(5).jet(0.0, 2)) == Approx(0.05).epsilon(1e-12));
  CHECK(curvature(fit.curve->segment(4).jet(1.0, 2)) == Approx(0.05).epsilon(1e-10));
}

TEST_CASE("intrinsic scheme: two points are the Hermite problem") {
  Input input{.points = {{0, 0}, {1, 0}}, .options = std::vector<PointOptions>(2)};
  CHECK(scheme("intrinsic")->fit(input).report.outcome == Outcome::converged);  // a straight line
  input.options[0] = {.tangent = -pi / 9, .curvature = 0.3};
  input.options[1] = {.tangent = pi / 3 - pi / 9, .curvature = 2.2};
  const Fit fit = scheme("intrinsic")->fit(input);
  REQUIRE(fit.report.outcome == Outcome::converged);
  CHECK(std::get<IntrinsicForm>(fit.curve->segment(0).exact()).length == Approx(1.0447610569786732).epsilon(1e-14));

  input.options[1].curvature = 1.55;
  const Fit refused = scheme("intrinsic")->fit(input);
  CHECK(refused.report.outcome == Outcome::unsupported_input);
  CHECK_THAT(refused.report.message, Contains("from point 0 to 1") && Contains("do not nest"));
  // One curvature alone leaves the other one free.
  Input half = input;
  half.options[1].curvature.reset();
  const Fit completed = scheme("intrinsic")->fit(half);
  REQUIRE(completed.report.outcome == Outcome::converged);
  CHECK(completed.report.counters.at("spans_not_monotone") == 0);
  CHECK(curvature(completed.curve->segment(0).jet(0.0, 2)) == Approx(0.3).epsilon(1e-13));
  // On fixed knots there is a curve, with an extremum.
  const Fit on_fixed_knots = scheme("intrinsic:auto=false")->fit(input);
  REQUIRE(on_fixed_knots.report.outcome == Outcome::converged);
  CHECK(extrema_inside(*on_fixed_knots.curve) > 0);
}

TEST_CASE("intrinsic scheme: extreme data end in time, and not as converged") {
  Input input{.points = {{0, 0}, {1, 0}}, .options = std::vector<PointOptions>(2)};
  input.options[0].tangent = pi;
  input.options[1].tangent = pi;
  CHECK(scheme("intrinsic")->fit(input).report.outcome == Outcome::converged);  // an S that starts and ends backwards
  for (const double curvature : {1e8, -1e8, 1e200}) {
    INFO(curvature);
    input.options[0] = {.tangent = -pi / 9, .curvature = curvature};
    input.options[1] = {.tangent = 2 * pi / 9};
    const Fit fit = scheme("intrinsic")->fit(input);
    CHECK((fit.report.outcome != Outcome::converged || fit.report.residual <= 1e-10));
  }
}

TEST_CASE("intrinsic scheme: a span depends on rounds + 3 points on each side") {
  for (const int rounds : {0, 1, 3}) {
    const SchemePtr tested = scheme("intrinsic:rounds=" + std::to_string(rounds));
    CHECK(tested->info().traits.locality == rounds + 3);
    const Input input = walk(9, 24);
    Input moved = input;
    moved.points[12] += Vec2(0.05, -0.03);
    const Fit one = tested->fit(input), other = tested->fit(moved);
    int first = 24, last = -1;
    for (int i = 0; i < 23; ++i) {
      const auto a = std::get<IntrinsicForm>(one.curve->segment(i).exact());
      const auto b = std::get<IntrinsicForm>(other.curve->segment(i).exact());
      if (a.control_curvatures == b.control_curvatures && a.angle == b.angle) continue;
      first = std::min(first, i);
      last = std::max(last, i);
    }
    CHECK(first >= 12 - (rounds + 3));
    CHECK(last <= 11 + (rounds + 3));
    CHECK(last - first + 1 > 2 * (rounds + 1));
  }
}

TEST_CASE("intrinsic scheme: legs that turn straight back need a tangent") {
  Input input{.points = {{0, 0}, {2, 0}, {1, 0}, {1, 2}}, .options = std::vector<PointOptions>(4)};
  const Fit refused = scheme("intrinsic")->fit(input);
  CHECK(refused.report.outcome == Outcome::unsupported_input);
  CHECK_THAT(refused.report.message, Contains("point 1"));
  input.options[1].tangent = 0.5 * pi;
  CHECK(scheme("intrinsic")->fit(input).curve);
}

TEST_CASE("intrinsic scheme: wrong options get one line") {
  CHECK_THROWS_WITH(scheme("intrinsic:degree=5,controls=4"), Contains("must be more than degree"));
  CHECK_THROWS_WITH(scheme("intrinsic:knots=0/0/0/x/1/1/1"), Contains("\"x/1/1/1\" is not a number"));
  CHECK_THROWS_WITH(scheme("intrinsic:knots=0/0/0/0.5/1/1"), Contains("must be 0 and 1"));
  CHECK_THROWS_WITH(scheme("intrinsic:knots=0/0/1/1"), Contains("too few"));
  CHECK_NOTHROW(scheme("intrinsic:knots=0/0/0/0.3/1/1/1"));
  CHECK_FALSE(scheme("intrinsic:knots=0/0/0/0.3/1/1/1")->info().traits.reversal_invariant);
  // G2 on three controls has nothing to solve for.
  Input input{.points = {{0, 0}, {1, 0}}, .options = std::vector<PointOptions>(2)};
  for (PointOptions& options : input.options) options = {.tangent = 0.3, .curvature = 1.0};
  CHECK_THAT(scheme("intrinsic:auto=false,degree=2,controls=3")->fit(input).report.message, Contains("too few"));
}

TEST_CASE("intrinsic scheme: g1 meets headings only, whatever curvatures are given") {
  Input input{.points = {{0, 0}, {10, 5}}, .closed = false};
  input.options = {{.tangent = 0.0}, {.tangent = 0.7}};
  const Fit free = scheme("intrinsic:continuity=g1")->fit(input);
  input.options[0].curvature = 0.1;
  input.options[1].curvature = 0.2;
  const Fit given = scheme("intrinsic:continuity=g1")->fit(input);
  REQUIRE((free.curve && given.curve));
  CHECK(given.report.outcome == Outcome::converged);
  for (const double t : {0.0, 0.3, 1.0})
    CHECK(given.curve->segment(0).jet(t, 0).position() == free.curve->segment(0).jet(t, 0).position());
}

TEST_CASE("intrinsic scheme: data without a monotone solution are refused with what meets them") {
  const auto between = [](const Vec2& end) {
    Input input{.points = {{0, 0}, end}, .closed = false};
    input.options = {{.tangent = 0.0, .curvature = 0.0}, {.tangent = 0.0, .curvature = 0.0}};
    return scheme("intrinsic")->fit(input).report;
  };
  // A lane change; and a line that would have to come back from infinity.
  for (const Vec2& end : {Vec2(150, 20), Vec2(-10, 0)}) {
    const Report report = between(end);
    CHECK(report.outcome == Outcome::unsupported_input);
    CHECK_THAT(report.message, Contains("clothoid3"));
  }
  CHECK(between({10, 0}).outcome == Outcome::converged);
}
