#include <cmath>

#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const Input open_input{.points = {{0, 0}, {2, 1}, {3, -1}, {5, 0.5}, {5.5, 3}}, .closed = false};
const Input closed_input{.points = {{0, 0}, {2, -1}, {3, 1}, {1.5, 2.5}, {-0.5, 1.5}}, .closed = true};

/// c'(t) and c''(t) with respect to the global parameter of a segment of length h.
Vec2 derivative(const Jet& jet, std::size_t order, double h) { return jet.d[order] / std::pow(h, order); }

}  // namespace

TEST_CASE("cubic-spline is C2 in its global parameter and passes through the points") {
  for (const auto& [text, alpha] : {std::pair{"cubic-spline", 1.0},
                                    {"cubic-spline:parameter=centripetal", 0.5},
                                    {"cubic-spline:parameter=uniform", 0.0}})
    for (const Input& input : {open_input, closed_input}) {
      INFO(text << (input.closed ? ", closed" : ", open"));
      const Fit fit = scheme(text)->fit(input);
      REQUIRE(fit.report.outcome == Outcome::converged);
      CHECK(fit.report.residual < 1e-14);
      const Curve& curve = *fit.curve;
      const auto h = [&](int i) {
        const auto n = input.points.size();
        const auto k = static_cast<std::size_t>(i);
        return std::pow((input.points[(k + 1) % n] - input.points[k]).norm(), alpha);
      };
      for (const Node& node : curve.nodes()) {
        const Vec2 at = curve.segment(node.segment).jet(node.t, 0).position();
        CHECK((at - input.points[static_cast<std::size_t>(node.point)]).norm() < 1e-14);
      }
      for (const Joint& joint : curve.joints()) {
        const Jet before = curve.segment(joint.segment).jet(1.0, 2);
        const Jet after = curve.segment(curve.next(joint.segment)).jet(0.0, 2);
        const double h0 = h(joint.segment), h1 = h(curve.next(joint.segment));
        for (const std::size_t order : {0U, 1U, 2U})
          CHECK((derivative(before, order, h0) - derivative(after, order, h1)).norm() < 1e-12);
      }
      if (!input.closed) {
        CHECK(curve.segment(0).jet(0.0, 2).d[2].norm() < 1e-12);
        CHECK(curve.segment(curve.size() - 1).jet(1.0, 2).d[2].norm() < 1e-12);
      }
    }
}

TEST_CASE("cubic-spline through two points is the straight line") {
  const Fit fit = scheme("cubic-spline")->fit({.points = {{0, 0}, {3, 1}}, .closed = false});
  REQUIRE(fit.curve.has_value());
  CHECK((fit.curve->segment(0).jet(0.25, 0).position() - Vec2(0.75, 0.25)).norm() < 1e-15);
}
