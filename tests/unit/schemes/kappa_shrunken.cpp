// Segments that shrink to their points at inflections: dropped where that is the solution, whatever Newton left of
// them.
#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

Input moved(std::vector<Vec2> points, const Vec2& by = {5.3, -3.1}) {
  for (Vec2& p : points) p += by;
  return {.points = std::move(points), .closed = false, .options = {}, .ids = {}};
}

/// Symmetric about point 3, the fourth: no curvature there.
std::vector<Vec2> symmetric() { return {{-90, 10}, {-60, 44}, {-30, 30}, {0, 0}, {30, -30}, {60, -44}, {90, -10}}; }

std::vector<Vec2> sine() {
  return {{-4.712389, 1},  {-3.843989, 0.646049},  {-3.141593, 0}, {-2.439196, -0.646049},
          {-1.570796, -1}, {-0.702397, -0.646049}, {0, 0},         {0.702397, 0.646049},
          {1.570796, 1},   {2.439196, 0.646049},   {3.141593, 0},  {3.843989, -0.646049},
          {4.712389, -1}};
}

constexpr const char* texts[] = {"kappa", "ekappa:a=0.6666666666666667", "ekappa:a=0.7", "ekappa", "ekappa-trig"};

/// Points are met, and every joint is what it claims, to rounding of control points as large as `size`.
void check_claims(const Fit& fit, double size) {
  const Curve& curve = *fit.curve;
  for (const Node& node : curve.nodes()) {
    const Vec2 at = curve.segment(node.segment).jet(node.t, 0).position();
    CHECK((at - fit.input.points[static_cast<std::size_t>(node.point)]).norm() <= 1e-13 * size);
  }
  for (const Joint& joint : curve.joints()) {
    if (joint.claimed == Continuity::g0) continue;
    const Jet before = curve.segment(joint.segment).jet(1.0, 2);
    const Jet after = curve.segment(curve.next(joint.segment)).jet(0.0, 2);
    const double v = std::min(speed(before), speed(after));
    CHECK(before.d[1].dot(after.d[1]) > 0.0);
    CHECK(std::abs(cross(before.d[1].normalized(), after.d[1].normalized())) <= 1e-12 + 1e-15 * size / v);
    if (joint.claimed == Continuity::g1) continue;
    const double k0 = std::abs(curvature(before)), k1 = std::abs(curvature(after));
    CHECK(std::abs(k0 - k1) <= std::min(0.1, 1e-9 + 1e-14 * size / (v * v * k0)) * std::max(k0, k1));
  }
}

}  // namespace

TEST_CASE("kappa: at an inflection by symmetry the neighbours meet on the point, with equal |curvature|") {
  for (const char* text : texts)
    for (const auto& points : {symmetric(), sine()})
      for (const Vec2& by : {Vec2(0, 0), Vec2(5.3, -3.1)}) {
        INFO(text << ", " << points.size() << " points");
        const Fit fit = scheme(text)->fit(moved(points, by));
        REQUIRE(fit.report.outcome == Outcome::converged);
        CHECK(fit.report.counters.at("at_inflection") == 1);
        check_claims(fit, 100.0);
        const auto node =
            std::ranges::find_if(fit.curve->nodes(), [](const Node& n) { return n.has("at_inflection"); });
        CHECK(node->point == static_cast<int>(points.size()) / 2);
        CHECK(fit.curve->joints()[static_cast<std::size_t>(node->segment)].claimed == Continuity::g1_equal_magnitude);
      }
}

TEST_CASE("kappa: near an inflection nothing is claimed that stored control points do not bear") {
  for (const char* text : {"kappa", "ekappa"})
    for (const double off : {1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
      INFO(text << ", off by " << off);
      std::vector<Vec2> points = symmetric();
      points.back().y() += 90.0 * off;
      const Fit fit = scheme(text)->fit(moved(points));
      REQUIRE(fit.report.outcome == Outcome::converged);
      check_claims(fit, 100.0);
    }
}

TEST_CASE("kappa: three points of very uneven chords are one equation, and solved") {
  for (const char* text : texts)
    for (const double ratio : {1e2, 1e3, 1e4, 1e5, 1e6}) {
      INFO(text << ", " << ratio);
      const Fit fit = scheme(text)->fit({.points = {{0, 0}, {1, 0}, {ratio, -0.005 * ratio}}, .closed = false});
      CHECK(fit.report.outcome == Outcome::converged);
      CHECK(fit.report.counters.at("pinned") == 0);
    }
}
