// The Euler-spiral spline: its equations and their derivatives, known curves, and what has no curve.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "schemes/curve/joint.hpp"
#include "schemes/euler_spiral/continuation.hpp"
#include "schemes/segments/clothoid.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::euler_spiral;
using namespace kappabench::test;

namespace {

using std::numbers::pi;

const std::vector<Vec2> points{{0, 0}, {2, 1}, {3, -1}, {5, 0.5}, {5.5, 3}, {3, 4}};
/// Solved, but by continuation only.
const std::vector<Vec2> hard{{3, 22}, {22, -65}, {56, 46}, {87, -44}};
/// Sharp teeth: an arc at either end cannot bend as much as the next span must.
const std::vector<Vec2> teeth{{0, 0}, {1, 30}, {2, -30}, {3, 30}, {4, -30}, {5, 30}};

Fit fit(std::vector<Vec2> through, bool closed = false) {
  return scheme("euler-spiral")->fit({.points = std::move(through), .closed = closed});
}

const ClothoidForm& clothoid(const Fit& fit, int k) {
  return static_cast<const ClothoidSegment&>(fit.curve->segment(k)).form();
}

double end_curvature(const ClothoidForm& c) { return c.curvature + c.curvature_rate * c.length; }

/// What makes the curve an Euler-spiral spline, by its clothoids alone.
void check_spline(const Fit& fit) {
  REQUIRE(fit.report.outcome == Outcome::converged);
  const int n = fit.input.size(), spans = fit.input.closed ? n : n - 1;
  REQUIRE(fit.curve->size() == spans);
  for (const Node& node : fit.curve->nodes()) {
    const Vec2 at = fit.curve->segment(node.segment).jet(node.t, 0).position();
    CHECK((at - fit.input.points[static_cast<std::size_t>(node.point)]).norm() < 1e-14 * mean_chord(fit.input));
  }
  for (const Joint& joint : fit.curve->joints()) {
    CHECK(joint.claimed == Continuity::g2);
    const ClothoidForm &a = clothoid(fit, joint.segment), &b = clothoid(fit, fit.curve->next(joint.segment));
    const double heading = a.angle + (a.curvature + 0.5 * a.curvature_rate * a.length) * a.length;
    CHECK(std::abs(std::remainder(heading - b.angle, 2.0 * pi)) < 1e-14);
    CHECK(std::abs(end_curvature(a) - b.curvature) * std::min(a.length, b.length) < 1e-13);
  }
}

/// Central differences of a function of one number.
template <class F>
double slope(const F& f, double at) {
  constexpr double h = 1e-5;
  return (f(at + h) - f(at - h)) / (2.0 * h);
}

Polygon given_polygon(bool closed) {
  Input input{.points = points, .closed = closed};
  if (!closed) {
    input.options.resize(points.size());
    input.options.back().tangent = 2.0;
  }
  return polygon_of(input);
}

}  // namespace

TEST_CASE("euler-spiral: derivatives of end curvatures, beyond half a turn too") {
  for (const double start : {-3.6, -2.0, -0.3, 0.0, 1.0, 3.1})
    for (const double end : {-3.0, -0.8, 0.0, 0.4, 2.5, 3.8}) {
      if (std::abs(end - start) > 6.0) continue;
      INFO("headings " << start << ", " << end);
      const auto span = span_between(start, end);
      REQUIRE(span.has_value());
      const auto check = [&](EndCurvature Span::*where) {
        const EndCurvature& found = (*span).*where;
        const double by_start = slope([&](double x) { return (*span_between(x, end).*where).value; }, start);
        const double by_end = slope([&](double x) { return (*span_between(start, x).*where).value; }, end);
        CHECK(found.by_start == Approx(by_start).epsilon(1e-7).margin(1e-8));
        CHECK(found.by_end == Approx(by_end).epsilon(1e-7).margin(1e-8));
      };
      check(&Span::at_start);
      check(&Span::at_end);
    }
  CHECK_FALSE(span_between(3.2, -3.2).has_value());  // two pi apart
  CHECK_FALSE(span_between(4.0, 1.0).has_value());
}

TEST_CASE("euler-spiral: Newton's step solves the equations to first order, and follows the turns") {
  for (const bool closed : {false, true}) {
    const Polygon polygon = given_polygon(closed);
    System system(polygon);
    const Found found = newton(system, circle_headings(polygon), 0.8);
    REQUIRE(found.solved());
    Headings step, by_bend;
    REQUIRE(system.evaluate(found.headings, 0.8));
    REQUIRE(system.solve(step, by_bend));
    constexpr double h = 1e-5;
    const Found less = newton(system, found.headings, 0.8 - h), more = newton(system, found.headings, 0.8 + h);
    Headings moved = found.headings;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      CHECK(by_bend[k] == Approx((more.headings[k] - less.headings[k]) / (2.0 * h)).epsilon(1e-7).margin(1e-8));
      moved[k] += 1e-4 * std::sin(static_cast<double>(k + 1));
    }
    REQUIRE(system.evaluate(moved, 0.8));
    const double before = system.residual();
    REQUIRE(system.solve(step, by_bend));
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += step[k];
    REQUIRE(system.evaluate(moved, 0.8));
    CHECK(before > 1e-5);
    CHECK(system.residual() < 1e-3 * before);
  }
}

TEST_CASE("euler-spiral: one clothoid a span, curvature continuous, arcs at open ends") {
  for (const bool closed : {false, true}) check_spline(fit(points, closed));
  const Fit open = fit(points);
  for (const int end : {0, 4}) CHECK(std::abs(clothoid(open, end).curvature_rate) < 1e-13);
  CHECK(std::abs(clothoid(open, 2).curvature_rate) > 0.1);
}

TEST_CASE("euler-spiral: given tangents at open ends") {
  Input input{.points = points, .closed = false};
  input.options.resize(points.size());
  input.options.front().tangent = -1.0;
  input.options.back().tangent = 2.5;
  const Fit both = scheme("euler-spiral")->fit(input);
  check_spline(both);
  CHECK(tangent_angle(both.curve->segment(0).jet(0.0, 1)) == Approx(-1.0));
  CHECK(tangent_angle(both.curve->segment(4).jet(1.0, 1)) == Approx(2.5));
  input.options.back() = {};
  const Fit one = scheme("euler-spiral")->fit(input);
  check_spline(one);
  CHECK(tangent_angle(one.curve->segment(0).jet(0.0, 1)) == Approx(-1.0));
  CHECK(std::abs(clothoid(one, 4).curvature_rate) < 1e-13);
}

TEST_CASE("euler-spiral: points of a clothoid with its end tangents give the clothoid") {
  const ClothoidForm known{.start = {1, 2}, .angle = 0.4, .curvature = -0.7, .curvature_rate = 0.9, .length = 3.0};
  Input input{.points = {}, .closed = false};
  const ClothoidSegment segment(known);
  for (const double t : {0.0, 0.13, 0.3, 0.32, 0.7, 1.0}) input.points.push_back(segment.jet(t, 0).position());
  input.options.resize(6);
  input.options.front().tangent = known.angle;
  input.options.back().tangent = tangent_angle(segment.jet(1.0, 1));
  const Fit found = scheme("euler-spiral")->fit(input);
  check_spline(found);
  double length = 0.0;
  for (int k = 0; k < 5; ++k) {
    CHECK(clothoid(found, k).curvature == Approx(known.curvature + known.curvature_rate * length).margin(1e-12));
    CHECK(clothoid(found, k).curvature_rate == Approx(known.curvature_rate).margin(1e-10));
    length += clothoid(found, k).length;
  }
  CHECK(length == Approx(known.length).epsilon(1e-13));
}

TEST_CASE("euler-spiral: a point added on the curve changes nothing") {
  for (const bool closed : {false, true})
    for (const std::size_t span : {std::size_t{0}, std::size_t{2}}) {
      const Fit before = fit(points, closed);
      std::vector<Vec2> more = points;
      const Segment& cut = before.curve->segment(static_cast<int>(span));
      more.insert(more.begin() + static_cast<std::ptrdiff_t>(span) + 1, cut.jet(0.3, 0).position());
      const Fit after = fit(more, closed);
      check_spline(after);
      for (int k = 0; k < before.curve->size(); ++k) {
        if (k == static_cast<int>(span)) continue;
        const int same = k > static_cast<int>(span) ? k + 1 : k;
        CHECK((before.curve->segment(k).jet(0.4, 0).position() - after.curve->segment(same).jet(0.4, 0).position())
                  .norm() < 1e-13);
      }
      CHECK((cut.jet(0.15, 0).position() - after.curve->segment(static_cast<int>(span)).jet(0.5, 0).position()).norm() <
            1e-13);
    }
}

TEST_CASE("euler-spiral on a circle is the circle, on a row the line, on two points the chord") {
  std::vector<Vec2> circle;
  for (const double angle : {0.0, 1.1, 1.3, 3.0, 5.5}) circle.emplace_back(std::cos(angle), std::sin(angle));
  for (const bool closed : {false, true}) {
    const Fit round = fit(circle, closed);
    check_spline(round);
    for (const SegmentPtr& segment : round.curve->segments())
      CHECK(segment->jet(0.37, 0).position().norm() == Approx(1.0).epsilon(1e-14));
  }
  for (const std::vector<Vec2>& row : {std::vector<Vec2>{{0, 0}, {1, 0}, {3, 0}}, {{0, 0}, {2, 0}}}) {
    const Fit line = fit(row);
    check_spline(line);
    CHECK(std::abs(line.curve->segment(0).jet(0.5, 0).position().y()) < 1e-15);
  }
  // Three points: the circle through them, also where the last is the first again.
  const Fit there_and_back = fit({{0, 0}, {10, 0}, {0, 0}});
  check_spline(there_and_back);
  CHECK(std::abs(curvature(there_and_back.curve->segment(0).jet(0.5, 2))) == Approx(0.2));
}

TEST_CASE("euler-spiral: two points with tangents are one clothoid") {
  Input input{.points = {{0, 0}, {2, 1}}, .closed = false};
  input.options.resize(2);
  input.options[0].tangent = 1.0;
  const Fit arc = scheme("euler-spiral")->fit(input);
  check_spline(arc);
  CHECK(tangent_angle(arc.curve->segment(0).jet(0.0, 1)) == Approx(1.0));
  CHECK(std::abs(clothoid(arc, 0).curvature_rate) < 1e-13);
  input.options[1].tangent = 0.5;
  const Fit both = scheme("euler-spiral")->fit(input);
  check_spline(both);
  CHECK(tangent_angle(both.curve->segment(0).jet(0.0, 1)) == Approx(1.0));
  CHECK(tangent_angle(both.curve->segment(0).jet(1.0, 1)) == Approx(0.5));
}

TEST_CASE("euler-spiral: spans that run away are named, and are no curve") {
  // The circle through the points has a radius of infinity, or of 12,500: the first span is all of it.
  for (const std::vector<Vec2>& fold : {std::vector<Vec2>{{0, 0}, {10, 0}, {5, 0}}, {{0, 0}, {10, 0}, {5, 1e-3}}}) {
    const Fit found = fit(fold);
    CHECK(found.report.outcome == Outcome::not_converged);
    CHECK_FALSE(found.curve.has_value());
    CHECK_THAT(found.report.message,
               ContainsSubstring("runs away") && ContainsSubstring("from point 0 to 1 turns by 3"));
  }
  const Fit zigzag = fit(teeth);
  CHECK(zigzag.report.outcome == Outcome::not_converged);
  CHECK_FALSE(zigzag.curve.has_value());
  CHECK_THAT(zigzag.report.message, ContainsSubstring("runs away") && ContainsSubstring("% of what they are") &&
                                        ContainsSubstring("a tangent given at point"));
  Input given{.points = teeth, .closed = false};
  given.options.resize(teeth.size());
  given.options.front().tangent = given.options.back().tangent = 0.5 * pi;
  check_spline(scheme("euler-spiral")->fit(given));
}

TEST_CASE("euler-spiral: continuation finds what Newton's method alone does not") {
  const Fit found = fit(hard);
  check_spline(found);
  CHECK(found.report.counters.at("continued") == 1);
  CHECK(fit(points).report.counters.at("continued") == 0);
}

TEST_CASE("euler-spiral: a turn that nearly folds back is taken to the other side where a span runs away") {
  const std::vector<Vec2> backtracking{{0, 0}, {40, 0}, {20, 0.5}, {60, 6}, {35, 7}, {80, 0}, {100, 0}};
  const Fit found = fit(backtracking);
  check_spline(found);
  CHECK(found.report.counters.at("other_side") > 0);
  for (const SegmentPtr& segment : found.curve->segments()) {
    const double chord = (segment->jet(1.0, 0).position() - segment->jet(0.0, 0).position()).norm();
    CHECK(static_cast<const ClothoidSegment&>(*segment).form().length < 3.0 * chord);
  }
  CHECK(fit(points).report.counters.at("other_side") == 0);
}

TEST_CASE("euler-spiral: where the path turns straight back the neighbours say to which side") {
  const std::vector<Vec2> back{{0, 0}, {5, 1}, {10, 2}, {5, 1}, {4, 4}};
  const double sign = polygon_of({.points = back, .closed = false}).turns[2];
  CHECK(std::abs(sign) == pi);
  for (const double angle : {0.3, 1.1, 2.0, 4.0}) {
    Input turned{.points = {}, .closed = false}, mirrored = turned, reversed = turned;
    for (const Vec2& p : back) {
      turned.points.emplace_back(Eigen::Rotation2Dd(angle) * p);
      mirrored.points.emplace_back(Eigen::Rotation2Dd(angle) * Vec2(p.x(), -p.y()));
    }
    reversed.points.assign(turned.points.rbegin(), turned.points.rend());
    CHECK(polygon_of(turned).turns[2] == sign);
    CHECK(polygon_of(mirrored).turns[2] == -sign);
    CHECK(polygon_of(reversed).turns[2] == -sign);
  }
}

TEST_CASE("euler-spiral refuses coincident and non-finite points") {
  CHECK(fit({{0, 0}, {0, 0}, {1, 1}}).report.outcome == Outcome::unsupported_input);
  CHECK(fit({{0, 0}, {INFINITY, 0}, {1, 1}}, true).report.outcome == Outcome::unsupported_input);
}
