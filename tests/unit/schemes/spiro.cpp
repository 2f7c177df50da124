// Levien's Euler-spiral spline through libspiro, with KAPPABENCH_WITH_SPIRO only.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::vector<Vec2> points{{0, 0}, {2, 1}, {3, -1}, {5, 0.5}, {5.5, 3}, {3, 4}};

}  // namespace

TEST_CASE("spiro: one clothoid a span, curvature continuous to 1e-7") {
  const SchemePtr spiro = scheme("spiro");
  for (const bool closed : {false, true}) {
    const Fit fit = spiro->fit({.points = points, .closed = closed});
    REQUIRE(fit.report.outcome == Outcome::converged);
    CHECK(fit.curve->size() == (closed ? 6 : 5));
    for (int k = 0; k < fit.curve->size(); ++k)
      CHECK(std::holds_alternative<ClothoidForm>(fit.curve->segment(k).exact()));
    for (const Node& node : fit.curve->nodes()) {
      const Vec2 at = fit.curve->segment(node.segment).jet(node.t, 0).position();
      CHECK((at - points[static_cast<std::size_t>(node.point)]).norm() < 1e-14);
    }
    for (const Joint& joint : fit.curve->joints()) {
      const Jet before = fit.curve->segment(joint.segment).jet(1.0, 2);
      const Jet after = fit.curve->segment(fit.curve->next(joint.segment)).jet(0.0, 2);
      CHECK(std::abs(cross(before.d[1].normalized(), after.d[1].normalized())) <= fit.report.residual + 1e-15);
      CHECK(curvature(before) == Approx(curvature(after)).epsilon(1e-7).margin(1e-8));
    }
    if (!closed) {  // ends are circular arcs
      CHECK(std::get<ClothoidForm>(fit.curve->segment(0).exact()).curvature_rate == 0.0);
      CHECK(std::get<ClothoidForm>(fit.curve->segment(4).exact()).curvature_rate == 0.0);
    }
  }
}

TEST_CASE("spiro on a regular polygon is the circle, on a straight row the line, on two points the chord") {
  const SchemePtr spiro = scheme("spiro");
  std::vector<Vec2> circle;
  for (int k = 0; k < 5; ++k)
    circle.emplace_back(std::cos(k * 0.4 * std::numbers::pi), std::sin(k * 0.4 * std::numbers::pi));
  const Fit round = spiro->fit({.points = circle, .closed = true});
  for (int k = 0; k < 5; ++k)
    CHECK(round.curve->segment(k).jet(0.37, 0).position().norm() == Approx(1.0).epsilon(1e-8));
  for (const std::vector<Vec2>& row : {std::vector<Vec2>{{0, 0}, {1, 0}, {3, 0}}, {{0, 0}, {2, 0}}}) {
    const Fit line = spiro->fit({.points = row, .closed = false});
    REQUIRE(line.report.outcome == Outcome::converged);
    CHECK(std::abs(line.curve->segment(0).jet(0.5, 0).position().y()) < 1e-12);
  }
}

TEST_CASE("spiro says when libspiro finds nothing, and never returns a broken curve") {
  const SchemePtr spiro = scheme("spiro");
  // Sharp teeth, a straight return, a hundred points on each other's heels.
  std::vector<std::vector<Vec2>> hard{{{0, 0}, {1, 30}, {2, -30}, {3, 30}, {4, -30}, {5, 30}},
                                      {{0, 0}, {4, 0}, {1, 0}, {2, 0}, {-3, 0}},
                                      {{0, 0}, {1e-6, 1e-6}, {5, 0}, {5, 1e-6}, {0, 3}}};
  for (const auto& row : hard)
    for (const bool closed : {false, true}) {
      const Fit fit = spiro->fit({.points = row, .closed = closed});
      if (fit.report.outcome == Outcome::converged) CHECK(fit.curve.has_value());
      if (fit.report.outcome != Outcome::converged) CHECK_FALSE(fit.report.message.empty());
      if (!fit.curve) continue;
      CHECK((fit.report.outcome == Outcome::converged) == (fit.report.residual <= 1e-7));
      for (const Jet& jet : sample(*fit.curve, 9, 4).jets)
        for (const Vec2& d : jet.d) CHECK(d.allFinite());
    }
  CHECK(spiro->fit({.points = {{0, 0}, {0, 0}, {1, 1}}, .closed = false}).report.outcome == Outcome::unsupported_input);
  CHECK(spiro->fit({.points = {{0, 0}, {INFINITY, 0}, {1, 1}}, .closed = true}).report.outcome ==
        Outcome::unsupported_input);
}

TEST_CASE("spiro and euler-spiral are one curve") {
  for (const bool closed : {false, true}) {
    const Fit peer = scheme("spiro")->fit({.points = points, .closed = closed});
    const Fit ours = scheme("euler-spiral")->fit({.points = points, .closed = closed});
    REQUIRE((peer.curve && ours.curve));
    for (int k = 0; k < ours.curve->size(); ++k)
      for (const double t : {0.2, 0.5, 0.9})
        CHECK((peer.curve->segment(k).jet(t, 0).position() - ours.curve->segment(k).jet(t, 0).position()).norm() <
              1e-7);
  }
}

TEST_CASE("spiro: a solution whose length its accuracy does not determine is none") {
  const SchemePtr spiro = scheme("spiro");
  const Fit fit = spiro->fit({.points = {{0, 0}, {10, 0}, {5, 0}}, .closed = false});
  CHECK(fit.report.outcome == Outcome::not_converged);
  CHECK_FALSE(fit.curve.has_value());
  CHECK(fit.report.message.find("chords long") != std::string::npos);
}
