// METAPOST's curves.
#include <array>
#include <cmath>
#include <numbers>

#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::vector<Vec2> points{{0, 0}, {60, 40}, {40, 90}, {10, 70}, {30, 50}};

std::vector<Vec2> control(const Curve& curve, int k) {
  return std::get<PolynomialForm>(curve.segment(k).exact()).control_points;
}

}  // namespace

TEST_CASE("hobby gives the control points that METAPOST prints") {
  // MetaPost: draw (0,0)..(60,40)..(40,90)..(10,70)..(30,50)..cycle; five decimals.
  constexpr std::array<std::array<double, 4>, 5> printed{{{5.18756, -26.8353, 60.36073, -18.40036},
                                                          {59.87714, 59.889, 57.33896, 81.64203},
                                                          {22.39987, 98.48387, 4.72404, 84.46368},
                                                          {13.38637, 60.7165, 26.35591, 59.1351},
                                                          {39.19409, 26.95198, -4.10555, 21.23804}}};
  const Fit fit = scheme("hobby")->fit({.points = points, .closed = true});
  REQUIRE(fit.report.outcome == Outcome::converged);
  CHECK(fit.report.residual < 1e-14);
  for (int k = 0; k < 5; ++k) {
    const auto& expected = printed[static_cast<std::size_t>(k)];
    const std::vector<Vec2> c = control(*fit.curve, k);
    CHECK((c[1] - Vec2(expected[0], expected[1])).norm() < 2e-5);
    CHECK((c[2] - Vec2(expected[2], expected[3])).norm() < 2e-5);
  }
}

TEST_CASE("hobby is G1 at the points, open and closed, for every tension and curl") {
  for (const std::string_view text : {"hobby", "hobby:tension=0.75", "hobby:tension=3", "hobby:curl=0", "hobby:curl=5"})
    for (const bool closed : {false, true}) {
      INFO(text << (closed ? ", closed" : ", open"));
      const Fit fit = scheme(text)->fit({.points = points, .closed = closed});
      REQUIRE(fit.report.outcome == Outcome::converged);
      for (const Joint& joint : fit.curve->joints()) {
        CHECK(joint.claimed == Continuity::g1);
        const Vec2 before = fit.curve->segment(joint.segment).jet(1.0, 1).d[1];
        const Vec2 after = fit.curve->segment(fit.curve->next(joint.segment)).jet(0.0, 1).d[1];
        CHECK(std::abs(cross(before, after)) < 1e-13 * before.norm() * after.norm());
        CHECK(before.dot(after) > 0.0);
      }
    }
}

TEST_CASE("hobby on points of a circle is nearly the circle: Hobby's velocity is made for that") {
  std::vector<Vec2> circle;
  for (int k = 0; k < 8; ++k)
    circle.emplace_back(std::cos(k * std::numbers::pi / 4), std::sin(k * std::numbers::pi / 4));
  const Fit fit = scheme("hobby")->fit({.points = circle, .closed = true});
  for (int k = 0; k < 8; ++k) CHECK(std::abs(fit.curve->segment(k).jet(0.5, 0).position().norm() - 1.0) < 1e-4);
}

TEST_CASE("curl 0 makes the ends of an open curve straight to first order, curl 1 like their neighbours") {
  const auto end_curvature = [&](std::string_view text) {
    return std::abs(curvature(scheme(text)->fit({.points = points, .closed = false}).curve->segment(0).jet(0.0, 2)));
  };
  CHECK(end_curvature("hobby:curl=0") < 0.2 * end_curvature("hobby"));
}

TEST_CASE("hobby takes given tangents") {
  Input input{.points = points, .closed = false};
  input.options.resize(5);
  for (const int k : {0, 2, 4}) input.options[static_cast<std::size_t>(k)].tangent = 0.4 * k - 2.9;
  for (const bool closed : {false, true}) {
    input.closed = closed;
    const Fit fit = scheme("hobby")->fit(input);
    REQUIRE(fit.report.outcome == Outcome::converged);
    for (const int k : {0, 2, 4}) {
      const double given = 0.4 * k - 2.9;
      if (k < fit.curve->size())
        CHECK(tangent_angle(fit.curve->segment(k).jet(0.0, 1)) == Approx(given).epsilon(1e-12));
      if (k > 0) CHECK(tangent_angle(fit.curve->segment(k - 1).jet(1.0, 1)) == Approx(given).epsilon(1e-12));
    }
  }
}

TEST_CASE("degenerate input of hobby") {
  const Fit two = scheme("hobby")->fit({.points = {{0, 0}, {3, 4}}, .closed = false});
  REQUIRE(two.report.outcome == Outcome::converged);
  CHECK((two.curve->segment(0).jet(0.5, 0).position() - Vec2(1.5, 2.0)).norm() < 1e-15);
  const Fit line = scheme("hobby")->fit({.points = {{0, 0}, {1, 0}, {3, 0}}, .closed = false});
  CHECK(std::abs(line.curve->segment(1).jet(0.3, 0).position().y()) < 1e-15);
  for (const bool closed : {false, true}) {
    const Fit back = scheme("hobby")->fit({.points = {{0, 0}, {4, 0}, {1, 0}, {2, 0}}, .closed = closed});
    REQUIRE(back.curve.has_value());
    for (const Jet& jet : sample(*back.curve, 9, 2).jets) CHECK(jet.position().allFinite());
  }
  CHECK(scheme("hobby")->fit({.points = {{0, 0}}, .closed = false}).report.outcome == Outcome::unsupported_input);
  CHECK(scheme("hobby")->fit({.points = {{0, 0}, {0, 0}}, .closed = false}).report.outcome ==
        Outcome::unsupported_input);
  CHECK_THROWS_AS(scheme("hobby:tension=0.5"), std::invalid_argument);
}
