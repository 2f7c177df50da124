// What the curves are: joints, pins, invariance, odd inputs, and the published iteration beside Newton's.

#include <Eigen/Geometry>
#include <limits>

#include "tests/catch.hpp"
#include "tests/unit/schemes/kappa_inputs.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

Input open_input(std::vector<Vec2> points) {
  return {.points = std::move(points), .closed = false, .options = {}, .ids = {}};
}

const char* const schemes[] = {"kappa", "ekappa:a=0.8", "ekappa-trig:a=0.8"};

/// Tangents agree at each joint, curvatures agree as claimed.
void check_joints(const Curve& curve, double size) {
  for (const Joint& joint : curve.joints()) {
    const Jet before = curve.segment(joint.segment).jet(1.0, 2);
    const Jet after = curve.segment(curve.next(joint.segment)).jet(0.0, 2);
    CHECK((before.position() - after.position()).norm() <= 1e-13 * size);
    CHECK(std::abs(cross(before.d[1].normalized(), after.d[1].normalized())) <= 1e-8);
    CHECK(before.d[1].dot(after.d[1]) > 0.0);
    const double k0 = curvature(before), k1 = curvature(after);
    CHECK(std::abs(k0) == Approx(std::abs(k1)).epsilon(1e-6).margin(1e-7 / size));
    if (joint.claimed == Continuity::g1_equal_magnitude)
      CHECK(k0 * k1 <= 0.0);
    else
      CHECK(k0 == Approx(k1).epsilon(1e-6).margin(1e-7 / size));
  }
}

/// The same point of the plane at the same parameter of corresponding segments.
double largest_difference(const Curve& one, const Curve& two, const Eigen::Affine2d& map, bool reversed) {
  REQUIRE(one.size() == two.size());
  double largest = 0.0;
  for (int i = 0; i < one.size(); ++i)
    for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      const Vec2 p = map * one.segment(i).jet(t, 0).position();
      const Vec2 q =
          reversed ? two.segment(one.size() - 1 - i).jet(1.0 - t, 0).position() : two.segment(i).jet(t, 0).position();
      largest = std::max(largest, (p - q).norm());
    }
  return largest;
}

}  // namespace

TEST_CASE("joints are as claimed", "[kappa]") {
  for (const char* scheme : schemes)
    for (const Family family : {Family::star, Family::zigzag, Family::square})
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Fit result = fit(scheme, random_input(family, seed));
        if (result.report.outcome != Outcome::converged) continue;
        INFO(scheme << ", family " << static_cast<int>(family) << ", seed " << seed);
        check_joints(*result.curve, mean_chord(result.input));
      }
}

TEST_CASE("points sit at curvature peaks, or at an end when pinned", "[kappa]") {
  long pinned = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Fit result = fit("kappa", random_input(Family::uneven_walk, seed));
    if (result.report.outcome != Outcome::converged) continue;
    pinned += result.report.counters.at("pinned");
    for (const Node& node : inner_nodes(result)) {
      const Segment& segment = result.curve->segment(node.segment);
      const double here = std::abs(curvature(segment.jet(node.t, 2)));
      for (const double t : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
        CHECK(std::abs(curvature(segment.jet(t, 2))) <= here * (1.0 + 1e-9));
      CHECK(node.has("pinned") == (node.t == 0.0 || node.t == 1.0));
    }
  }
  CHECK(pinned > 0);
}

TEST_CASE("similar inputs give similar curves, reversed ones the reversed curve", "[kappa]") {
  for (const char* scheme : schemes)
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Input input = random_input(Family::zigzag, seed);
      const Fit plain = fit(scheme, input);
      REQUIRE(plain.report.outcome == Outcome::converged);
      Eigen::Affine2d map = Eigen::Affine2d::Identity();
      map.translate(Vec2(100.0, -40.0)).rotate(0.7).scale(37.0);
      Input moved = input, reversed = input;
      for (Vec2& p : moved.points) p = map * p;
      std::reverse(reversed.points.begin(), reversed.points.end());
      const Fit moved_fit = fit(scheme, moved), reversed_fit = fit(scheme, reversed);
      REQUIRE(moved_fit.curve.has_value());
      REQUIRE(reversed_fit.curve.has_value());
      INFO(scheme << ", seed " << seed);
      CHECK(largest_difference(*plain.curve, *moved_fit.curve, map, false) <= 1e-9 * mean_chord(moved));
      if (!input.closed)
        CHECK(largest_difference(*plain.curve, *reversed_fit.curve, Eigen::Affine2d::Identity(), true) <=
              1e-9 * mean_chord(input));
    }
}

TEST_CASE("a point at an inflection loses its segment", "[kappa]") {
  for (const char* scheme : schemes) {
    const Fit result = fit(scheme, open_input({{-2, 0}, {-1, 1}, {0, 0}, {1, -1}, {2, 0}}));
    INFO(scheme);
    REQUIRE(result.report.outcome == Outcome::converged);
    CHECK(result.curve->size() == 2);
    CHECK(result.report.counters.at("at_inflection") == 1);
    const std::vector<Node> nodes = inner_nodes(result);
    REQUIRE(nodes.size() == 3);
    CHECK(nodes[1].has("at_inflection"));
    CHECK(largest_miss(result) <= 1e-12);
    CHECK(result.curve->joints().front().claimed == Continuity::g1_equal_magnitude);
    check_joints(*result.curve, 1.0);
  }
}

TEST_CASE("points on a line give the line, or a reason", "[kappa]") {
  for (const char* scheme : schemes) {
    const Fit line = fit(scheme, open_input({{0, 0}, {1, 0.5}, {4, 2}, {5, 2.5}}));
    REQUIRE(line.report.outcome == Outcome::converged);
    CHECK(largest_miss(line) <= 1e-14);
    CHECK(std::abs(curvature(line.curve->segment(0).jet(0.5, 2))) == 0.0);

    const Fit folded = fit(scheme, open_input({{0, 0}, {4, 2}, {1, 0.5}, {5, 2.5}}));
    CHECK(folded.report.outcome == Outcome::unsupported_input);
    CHECK(folded.report.message.find("line") != std::string::npos);
    Input closed = line.input;
    closed.closed = true;
    CHECK(fit(scheme, closed).report.outcome == Outcome::unsupported_input);
  }
}

TEST_CASE("odd inputs end in an outcome, never in numbers that are none", "[kappa]") {
  const std::vector<Input> inputs = {
      open_input({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 1}}),                          // a collinear run
      open_input({{0, 0}, {1, 1}, {2, 0}, {1, 1}, {0, 0}}),                          // there and back
      open_input({{0, 0}, {1, 0}, {1, 1e-7}, {2, 0}, {2, 1}}),                       // nearly coincident
      open_input({{1e9, 1e9}, {1e9 + 1, 1e9}, {1e9 + 1, 1e9 + 1}, {1e9, 1e9 + 2}}),  // far from the origin
      open_input({{0, 0}, {1e-150, 0}, {1e-150, 1e-150}, {0, 2e-150}}),              // tiny
      open_input({{0, 0}, {1, 0}, {0, 0}, {1, 0}, {1, 1}}),                          // zero area twice
      {.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .closed = true, .options = {}, .ids = {}},
      {.points = {{0, 0}, {2, 0}, {1, 1e-6}}, .closed = true, .options = {}, .ids = {}}};
  for (const char* scheme : {"kappa", "ekappa:a=0.99", "ekappa-trig:a=0.5"})
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const Fit result = fit(scheme, inputs[i]);
      INFO(scheme << ", input " << i << ": " << result.report.message);
      CHECK(std::isfinite(result.report.residual));
      if (!result.curve) {
        CHECK_FALSE(result.report.message.empty());
        continue;
      }
      for (const SegmentPtr& segment : result.curve->segments())
        for (const double t : {0.0, 0.5, 1.0}) CHECK(segment->jet(t, 2).position().allFinite());
      if (result.report.outcome == Outcome::converged)
        CHECK(largest_miss(result) <= (i == 3 ? 1e-6 : 1e-9));  // 1e9 has 7 digits left
    }
}

TEST_CASE("an a out of range is refused with the point's number", "[kappa]") {
  Input input = open_input({{0, 0}, {1, 2}, {4, 1}});
  input.options.resize(3);
  input.options[1].a = 0.6;
  const Fit result = fit("ekappa", input);
  CHECK(result.report.outcome == Outcome::unsupported_input);
  CHECK(result.report.message.find("point 1") != std::string::npos);
  CHECK(fit("ekappa-trig", input).report.outcome == Outcome::converged);
  CHECK(fit("kappa", input).report.outcome == Outcome::converged);
  input.options[1].a = std::numeric_limits<double>::quiet_NaN();
  CHECK(fit("ekappa", input).report.outcome == Outcome::unsupported_input);
}

TEST_CASE("the published iteration reaches the same curve, and says so when it does not", "[kappa]") {
  const Input input = random_input(Family::zigzag, 3);
  for (const std::string scheme : {"kappa", "ekappa", "ekappa-trig"}) {
    const Fit newton = fit(scheme, input);
    const Fit published = fit(scheme + ":iteration=published,max_iterations=5000", input);
    REQUIRE(newton.report.outcome == Outcome::converged);
    REQUIRE(published.report.outcome == Outcome::converged);
    CHECK(largest_difference(*newton.curve, *published.curve, Eigen::Affine2d::Identity(), false) <=
          1e-9 * mean_chord(input));
    CHECK(published.report.iterations > newton.report.iterations);
    // Both traces begin at the same state and are measured alike.
    CHECK(published.report.trace.front() == newton.report.trace.front());
    CHECK(published.report.trace.size() == static_cast<std::size_t>(published.report.iterations) + 1);

    const Fit early = fit(scheme + ":iteration=published,max_iterations=3", input);
    CHECK(early.report.outcome == Outcome::not_converged);
    CHECK(early.report.residual > 1e-12);
    CHECK(early.report.iterations == 3);
    CHECK(early.curve.has_value());
  }
}

TEST_CASE("where a point must be pinned the published iteration slides and is not called converged", "[kappa]") {
  int pinned = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Input input = random_input(Family::uneven_walk, seed);
    const Fit newton = fit("kappa", input);
    if (newton.report.outcome != Outcome::converged || newton.report.counters.at("pinned") == 0) continue;
    ++pinned;
    const Fit published = fit("kappa:iteration=published,max_iterations=300", input);
    CHECK((published.report.outcome == Outcome::not_converged || published.report.counters.at("pinned") > 0));
  }
  CHECK(pinned > 3);
}
