// What schemes claim of joints where the path has no direction, or turns straight back; and curves through two points.
#include "schemes/segments/joint_claim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

PolynomialSegment bezier(std::array<Vec2, 3> points) { return PolynomialSegment(points); }

const Input retrace{.points = {{0, 0}, {5, 1}, {10, 0}, {5, 1}, {0, 0}}, .closed = false};

/// Back on the leg by which it came, not to its start.
const Input there_and_back{.points = {{0, 0}, {10, 12}, {7, 8}, {3, 8}, {7, 8}, {10, 4}}, .closed = false};

/// The same path turned and moved, so that nothing is a round number.
Input turned(const Input& input, double angle, const Vec2& shift) {
  Input moved = input;
  for (Vec2& p : moved.points)
    p = Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()) +
        shift;
  return moved;
}

/// Angle between the directions on both sides of a joint, pi if one of them has none.
double turn_at(const Curve& curve, const Joint& joint) {
  const Vec2 before = curve.segment(joint.segment).jet(1.0, 1).d[1];
  const Vec2 after = curve.segment(curve.next(joint.segment)).jet(0.0, 1).d[1];
  if (std::min(before.norm(), after.norm()) < 1e-13) return 3.14;
  return std::abs(std::atan2(cross(before, after), before.dot(after)));
}

}  // namespace

TEST_CASE("a joint is claimed G0 where the path turns straight back or has no direction") {
  const auto arriving = bezier({Vec2(0, 0), Vec2(1, 1), Vec2(2, 1)});
  const auto onwards = bezier({Vec2(2, 1), Vec2(3, 1), Vec2(4, 0)});
  const auto back = bezier({Vec2(2, 1), Vec2(1, 1), Vec2(0, 0)});
  const auto nearly_back = bezier({Vec2(2, 1), Vec2(1, 1 + 1e-9), Vec2(0, 0)});
  const auto resting = bezier({Vec2(2, 1), Vec2(2, 1), Vec2(4, 0)});
  const auto nearly_resting = bezier({Vec2(2, 1), Vec2(2 + 2e-15, 1), Vec2(4, 0)});
  for (const Continuity smooth : {Continuity::g1, Continuity::g2, Continuity::c2}) {
    CHECK(claim_at(arriving, onwards, smooth) == smooth);
    for (const auto& after : {back, nearly_back, resting, nearly_resting})
      CHECK(claim_at(arriving, after, smooth) == Continuity::g0);
    // Slow, but with a direction.
    CHECK(claim_at(arriving, bezier({Vec2(2, 1), Vec2(2 + 1e-9, 1), Vec2(4, 0)}), smooth) == smooth);
  }
}

TEST_CASE("across a segment that has shrunk to a point no more is claimed than holds") {
  const auto arriving = bezier({Vec2(0, 0), Vec2(1, 1), Vec2(2, 1)});
  const auto mirrored = bezier({Vec2(2, 1), Vec2(3, 1), Vec2(4, 2)});
  CHECK(claim_found(arriving, mirrored, Continuity::g1_equal_magnitude) == Continuity::g1_equal_magnitude);
  const auto other_curvature = bezier({Vec2(2, 1), Vec2(3, 1), Vec2(4, 2 + 1e-9)});
  CHECK(claim_found(arriving, other_curvature, Continuity::g1_equal_magnitude) == Continuity::g1);
  const auto kinked = bezier({Vec2(2, 1), Vec2(3, 1 + 1e-9), Vec2(4, 2)});
  CHECK(claim_found(arriving, kinked, Continuity::g1_equal_magnitude) == Continuity::g0);
}

TEST_CASE("no scheme claims a direction where a path goes back as it came") {
  std::vector<std::string> texts{"ekappa:a=0.95", "cubic-spline:parameter=uniform", "catmull-rom:alpha=0",
                                 "yuksel:arc=bezier", "pkappa:continuity=g1"};
  for (const SchemeInfo& info : all_schemes().list()) texts.push_back(info.id);
  for (const std::string& text : texts)
    for (const Input& path : {retrace, there_and_back})
      for (const Input& input : {path, turned(path, 0.7, {3.1, -2.3})}) {
        INFO(text);
        const Fit fit = scheme(text)->fit(input);
        // Who draws nothing says why.
        CHECK((fit.report.outcome == Outcome::converged || !fit.report.message.empty()));
        if (!fit.curve) continue;
        for (const Joint& joint : fit.curve->joints())
          CHECK((turn_at(*fit.curve, joint) > 1.0) == (joint.claimed == Continuity::g0));
      }
  for (const char* text :
       {"kappa", "ekappa", "ekappa-trig", "fpc", "cubic-spline", "catmull-rom", "yuksel:arc=bezier"}) {
    INFO(text);
    const Fit fit = scheme(text)->fit(retrace);
    CHECK(std::ranges::count(fit.curve->joints(), Continuity::g0, &Joint::claimed) == 1);
  }
}

TEST_CASE("two points are joined by a line, with every scheme") {
  for (const SchemeInfo& info : all_schemes().list()) {
    INFO(info.id);
    for (const Input& input : {Input{.points = {{0, 0}, {4, 1}}, .closed = false},
                               Input{.points = {{-3e5, 2.5}, {7.25, 1e4}}, .closed = false}}) {
      const Fit fit = scheme(info.id)->fit(input);
      REQUIRE(fit.report.outcome == Outcome::converged);
      const Vec2 chord = input.points[1] - input.points[0];
      for (const Jet& jet : sample(*fit.curve, 9, 1).jets) {
        const Vec2 way = jet.position() - input.points[0];
        CHECK(std::abs(cross(way, chord)) <= 1e-14 * chord.squaredNorm());
        CHECK(std::abs(cross(jet.d[1], chord)) <= 1e-14 * jet.d[1].norm() * chord.norm());
        CHECK(jet.d[1].dot(chord) > 0.0);
        CHECK(way.dot(chord) >= -1e-15 * chord.squaredNorm());
        CHECK(way.dot(chord) <= (1.0 + 1e-15) * chord.squaredNorm());
      }
    }
  }
}

TEST_CASE("two points are joined by a line, of one segment") {
  for (const char* text :
       {"kappa", "kappa:iteration=published", "ekappa", "ekappa-trig", "fpc", "yuksel",
        "yuksel:arc=bezier,parametrization=c2", "pkappa", "pkappa:mode=global", "pkappa:mode=paper"}) {
    INFO(text);
    const Fit fit = scheme(text)->fit({.points = {{0, 0}, {4, 1}}, .closed = false});
    REQUIRE(fit.report.outcome == Outcome::converged);
    CHECK(fit.curve->size() == 1);
    CHECK(fit.curve->nodes().size() == 2);
    CHECK(fit.curve->start() == Vec2(0, 0));
    CHECK(fit.curve->end() == Vec2(4, 1));
    CHECK(fit.curve->segment(0).jet(0.25, 1).position() == Vec2(1, 0.25));
  }
}

TEST_CASE("pkappa: a line of two points takes a third one, and gives it back") {
  const SchemePtr pkappa = scheme("pkappa");
  const Fit line = pkappa->fit({.points = {{0, 0}, {4, 1}}, .closed = false});
  const Fit three = pkappa->refit(line, Insert{.before = 1, .at = {2, 2}});
  REQUIRE(three.report.outcome == Outcome::converged);
  CHECK(three.curve->nodes().size() == 3);
  const Fit again = pkappa->refit(three, Erase{.point = 1});
  REQUIRE(again.report.outcome == Outcome::converged);
  CHECK(again.curve->size() == 1);
}
