#include "metrics/continuity.hpp"

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

Curve two(const std::vector<Vec2>& a, const std::vector<Vec2>& b, Continuity claim) {
  return Curve({bezier(a), bezier(b)}, {{0, claim}}, {{0, 0, 0.0}, {1, 0, 1.0}, {2, 1, 1.0}}, false);
}

}  // namespace

TEST_CASE("a circle of four arcs is C2 and has no jumps", "[continuity]") {
  const Fit fit = fit_of(circle(3.0));
  CHECK(value(fit, "continuity", "continuity_violations") == 0.0);
  CHECK(value(fit, "continuity", "continuity_second_derivative_jump") < 1e-13);
  CHECK(value(fit, "continuity", "continuity_curvature_jump_all") < 1e-13);
  CHECK(std::isnan(value(fit, "continuity", "continuity_signed_jump_equal_magnitude")));
}

TEST_CASE("a corner of 90 degrees and a gap are measured", "[continuity]") {
  const Fit corner = fit_of(two({{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, Continuity::g1));
  CHECK(value(corner, "continuity", "continuity_angle_jump") == Approx(std::numbers::pi / 2));
  CHECK(value(corner, "continuity", "continuity_violations") == 1.0);
  const Fit claimed_corner = fit_of(two({{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, Continuity::g0));
  CHECK(value(claimed_corner, "continuity", "continuity_violations") == 0.0);
  const Fit gap = fit_of(two({{0, 0}, {1, 0}}, {{1.5, 0}, {2.5, 0}}, Continuity::g0));
  CHECK(value(gap, "continuity", "continuity_position_gap") == Approx(0.5 / mean_chord(gap.input)));
  CHECK(value(gap, "continuity", "continuity_violations") == 1.0);
}

TEST_CASE("an S of two mirrored parabolas has equal curvature of opposite sign", "[continuity]") {
  const std::vector<Vec2> a{{0, 0}, {1, 1}, {2, 0}};
  const std::vector<Vec2> b{{2, 0}, {3, -1}, {4, 0}};
  const Fit good = fit_of(two(a, b, Continuity::g1_equal_magnitude));
  CHECK(value(good, "continuity", "continuity_violations") == 0.0);
  CHECK(value(good, "continuity", "continuity_curvature_jump_equal_magnitude") < 1e-14);
  CHECK(value(good, "continuity", "continuity_signed_jump_equal_magnitude") == Approx(2.0));
  CHECK(std::isnan(value(good, "continuity", "continuity_curvature_jump_g2")));
  const Fit bad = fit_of(two(a, b, Continuity::g2));
  CHECK(value(bad, "continuity", "continuity_curvature_jump_g2") == Approx(2.0));
  CHECK(value(bad, "continuity", "continuity_violations") == 1.0);
}

TEST_CASE("the claim decides which derivatives count", "[continuity]") {
  // Same tangent line, other speed and curvature: G1 holds, C1 does not.
  const std::vector<Vec2> a{{0, 0}, {1, 0}, {2, 1}};
  const std::vector<Vec2> b{{2, 1}, {4, 3}, {5, 3}};
  CHECK(value(fit_of(two(a, b, Continuity::g1)), "continuity", "continuity_violations") == 0.0);
  const Fit c1 = fit_of(two(a, b, Continuity::c1));
  CHECK(value(c1, "continuity", "continuity_violations") == 1.0);
  CHECK(value(c1, "continuity", "continuity_first_derivative_jump") == Approx(0.5));
  CHECK(value(fit_of(two(a, {{2, 1}, {3, 2}, {5, 3}}, Continuity::c1)), "continuity", "continuity_violations") == 0.0);
  CHECK(value(fit_of(two(a, {{2, 1}, {3, 2}, {5, 3}}, Continuity::c2)), "continuity", "continuity_violations") == 1.0);
  CHECK(value(fit_of(two(a, {{2, 1}, {3, 2}, {4, 4}}, Continuity::c2)), "continuity", "continuity_violations") == 0.0);
}

TEST_CASE("a segment that rests at its end still has a tangent", "[continuity]") {
  const Fit fit = fit_of(two({{0, 0}, {1, 0}, {1, 0}}, {{1, 0}, {1, 0}, {2, 0}}, Continuity::g1));
  CHECK(value(fit, "continuity", "continuity_angle_jump") < 1e-15);
  CHECK(value(fit, "continuity", "continuity_violations") == 0.0);
}
