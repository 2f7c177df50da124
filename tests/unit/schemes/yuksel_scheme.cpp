// Trigonometric blending: what the curves promise, and degenerate input.
#include <cmath>
#include <numbers>

#include "schemes/yuksel/local_curve.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::vector<Vec2> points{{0, 0}, {2, 1}, {3, -1}, {5, 0.5}, {5.5, 3}, {3, 4}, {2.5, 6}, {-1, 5}, {0.5, 2.5}};
const Input open_input{.points = points, .closed = false};
const Input closed_input{.points = points, .closed = true};
constexpr std::array arcs{"bezier", "circular", "elliptical", "hybrid"};

}  // namespace

TEST_CASE("yuksel passes through the points with continuous tangent and curvature") {
  for (const std::string arc : arcs)
    for (const Input& input : {open_input, closed_input}) {
      INFO(arc << (input.closed ? ", closed" : ", open"));
      const Fit fit = scheme("yuksel:arc=" + arc)->fit(input);
      REQUIRE(fit.report.outcome == Outcome::converged);
      CHECK(fit.curve->size() == (input.closed ? 9 : 8));
      for (const Node& node : fit.curve->nodes()) {
        const Vec2 at = fit.curve->segment(node.segment).jet(node.t, 0).position();
        CHECK((at - points[static_cast<std::size_t>(node.point)]).norm() < 1e-14);
      }
      for (const Joint& joint : fit.curve->joints()) {
        CHECK(joint.claimed == Continuity::g2);
        const Jet before = fit.curve->segment(joint.segment).jet(1.0, 2);
        const Jet after = fit.curve->segment(fit.curve->next(joint.segment)).jet(0.0, 2);
        CHECK(std::abs(cross(before.d[1].normalized(), after.d[1].normalized())) < 1e-13);
        CHECK(before.d[1].dot(after.d[1]) > 0.0);
        CHECK(curvature(before) == Approx(curvature(after)).epsilon(1e-12));
      }
    }
}

TEST_CASE("yuksel: curvature is continuous at the ends of a leg of 1e-7, too") {
  const Input almost_closed{.points = {{0, 0}, {3, -2}, {7, -1}, {8, 3}, {4, 5}, {1, 3}, {8e-8, 6e-8}}, .closed = true};
  for (const std::string arc : arcs) {
    INFO(arc);
    const Fit fit = scheme("yuksel:arc=" + arc)->fit(almost_closed);
    REQUIRE(fit.report.outcome == Outcome::converged);
    for (const Joint& joint : fit.curve->joints()) {
      const Jet before = fit.curve->segment(joint.segment).jet(1.0, 2);
      const Jet after = fit.curve->segment(fit.curve->next(joint.segment)).jet(0.0, 2);
      CHECK(before.d[1].dot(after.d[1]) > 0.0);
      CHECK(std::abs(cross(before.d[1].normalized(), after.d[1].normalized())) < 1e-9);
      CHECK(curvature(before) == Approx(curvature(after)).epsilon(1e-7));
    }
  }
}

TEST_CASE("yuksel with parametrization=c2 has continuous derivatives, with the published one not") {
  for (const std::string arc : arcs) {
    const SchemePtr smooth = scheme("yuksel:parametrization=c2,arc=" + arc);
    CHECK(smooth->info().traits.continuity == Continuity::c2);
    double jump_of_published = 0.0;
    const Fit c2 = smooth->fit(closed_input), g2 = scheme("yuksel:arc=" + arc)->fit(closed_input);
    REQUIRE((c2.curve && g2.curve));
    for (const Joint& joint : c2.curve->joints()) {
      CHECK(joint.claimed == Continuity::c2);
      const int next = c2.curve->next(joint.segment);
      const Jet before = c2.curve->segment(joint.segment).jet(1.0, 2), after = c2.curve->segment(next).jet(0.0, 2);
      for (const std::size_t r : {1U, 2U}) CHECK((before.d[r] - after.d[r]).norm() < 1e-12 * before.d[r].norm());
      jump_of_published = std::max(
          jump_of_published,
          (g2.curve->segment(joint.segment).jet(1.0, 1).d[1] - g2.curve->segment(next).jet(0.0, 1).d[1]).norm());
    }
    CHECK(jump_of_published > 0.1);
    // Not the blend, but the local curves at open ends are the same shape.
    CHECK(curvature(c2.curve->segment(0).jet(0.0, 2)) == Approx(curvature(g2.curve->segment(0).jet(0.0, 2))));
  }
}

TEST_CASE("the curvature of a Bezier local curve peaks at its middle point") {
  const auto pair = yuksel::local_curve(yuksel::Arc::bezier, {0, 0}, {1, 2}, {4, 1});
  REQUIRE(pair.has_value());
  CHECK(curvature_derivative(pair->first->jet(1.0, 3)) == Approx(0.0).margin(1e-13));
  CHECK(std::abs(curvature(pair->first->jet(0.9, 2))) < std::abs(curvature(pair->first->jet(1.0, 2))));
  CHECK(std::abs(curvature(pair->second->jet(0.1, 2))) < std::abs(curvature(pair->second->jet(0.0, 2))));
  // The parameter of the kappa-curve through these points.
  CHECK(pair->first_extent == Approx(0.4396682658277627).epsilon(1e-14));
}

TEST_CASE("hybrid is circular where the circle turns gently, else elliptical") {
  const auto same = [](std::string_view a, std::string_view b, const Input& input) {
    return scheme(a)->fit(input).curve->segment(0).jet(0.3, 0).position() ==
           scheme(b)->fit(input).curve->segment(0).jet(0.3, 0).position();
  };
  const Input gentle{.points = {{0, 0}, {2, 1}, {4, 0}}, .closed = false};
  const Input sharp{.points = {{0, 0}, {2, 9}, {4, 0}}, .closed = false};
  CHECK(same("yuksel", "yuksel:arc=circular", gentle));
  CHECK_FALSE(same("yuksel", "yuksel:arc=elliptical", gentle));
  CHECK(same("yuksel", "yuksel:arc=elliptical", sharp));
  CHECK_FALSE(same("yuksel", "yuksel:arc=circular", sharp));
}

TEST_CASE("a moved point changes two spans on each side and no more") {
  for (const std::string arc : arcs)
    for (const Input& input : {open_input, closed_input}) {
      const SchemePtr tested = scheme("yuksel:arc=" + arc);
      CHECK(tested->info().traits.locality == 2);
      const Fit before = tested->fit(input), after = tested->fit(apply(input, Move{4, points[4] + Vec2(0.05, 0.03)}));
      for (int k = 0; k < before.curve->size(); ++k) {
        const bool near = k >= 2 && k <= 5;  // spans 4 - 2 to 4 + 1
        const double moved =
            (before.curve->segment(k).jet(0.5, 0).position() - after.curve->segment(k).jet(0.5, 0).position()).norm();
        INFO(arc << ", span " << k);
        CHECK((near ? moved > 1e-6 : moved == 0.0));
      }
    }
}

TEST_CASE("three points in a row are one local curve; straight rows are straight") {
  const Fit arc = scheme("yuksel:arc=circular")->fit({.points = {{1, 0}, {0, 1}, {-1, 0}}, .closed = false});
  REQUIRE(arc.curve.has_value());
  for (const int k : {0, 1})
    for (const double t : {0.1, 0.6}) CHECK(arc.curve->segment(k).jet(t, 0).position().norm() == Approx(1.0));
  for (const std::string name : arcs) {
    const Fit line = scheme("yuksel:arc=" + name)->fit({.points = {{0, 0}, {1, 0}, {3, 0}, {4, 0}}, .closed = false});
    REQUIRE(line.report.outcome == Outcome::converged);
    for (int k = 0; k < 3; ++k)
      for (const double t : {0.0, 0.3, 0.8, 1.0})
        CHECK(std::abs(line.curve->segment(k).jet(t, 0).position().y()) < 1e-15);
  }
}

TEST_CASE("legs that turn straight back: a cusp of the Bezier curve, and a clear refusal of circle and ellipse") {
  const Input input{.points = {{0, 0}, {4, 0}, {1, 0}, {1, 3}}, .closed = false};
  const Fit bezier = scheme("yuksel:arc=bezier")->fit(input);
  REQUIRE(bezier.report.outcome == Outcome::converged);
  for (const Jet& jet : sample(*bezier.curve, 9, 4).jets)
    for (const Vec2& d : jet.d) CHECK(d.allFinite());
  for (const std::string_view arc : {"circular", "elliptical", "hybrid"}) {
    const Fit fit = scheme("yuksel:arc=" + std::string(arc))->fit(input);
    CHECK(fit.report.outcome == Outcome::unsupported_input);
    CHECK_THAT(fit.report.message, ContainsSubstring("point 1") && ContainsSubstring("arc=bezier"));
    CHECK_FALSE(fit.curve.has_value());
  }
}

TEST_CASE("yuksel refuses too few, coincident and non-finite points, and unknown words") {
  CHECK(scheme("yuksel")->fit({.points = {{0, 0}}, .closed = false}).report.outcome == Outcome::unsupported_input);
  CHECK(scheme("yuksel")->fit({.points = {{0, 0}, {1, 0}, {1, 0}, {2, 2}}, .closed = false}).report.outcome ==
        Outcome::unsupported_input);
  CHECK(scheme("yuksel")->fit({.points = {{0, 0}, {NAN, 0}, {2, 2}}, .closed = true}).report.outcome ==
        Outcome::unsupported_input);
  CHECK_THROWS_AS(scheme("yuksel:arc=parabola"), std::invalid_argument);
  CHECK_THROWS_AS(yuksel::arc_of("parabola"), std::logic_error);
}
