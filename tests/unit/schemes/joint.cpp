// The glance at control points says of a joint only what the closer look says, too.
#include "schemes/curve/joint.hpp"

#include <cmath>
#include <random>

#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// Two random Bézier segments that meet with `kept` continuity of the parameters, up to an error of `off`.
std::pair<std::vector<Vec2>, std::vector<Vec2>> pair_of(std::mt19937_64& random, int kept, double off) {
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec2(normal(random), normal(random)); };
  const auto degree0 = 2 + random() % 4, degree1 = 2 + random() % 4;
  std::vector<Vec2> before, after;
  for (std::size_t i = 0; i <= degree0; ++i) before.push_back(any());
  for (std::size_t i = 0; i <= degree1; ++i) after.push_back(any());
  const auto n0 = static_cast<double>(degree0), n1 = static_cast<double>(degree1);
  const Vec2 a = before[degree0] - before[degree0 - 1], a2 = before[degree0 - 1] - before[degree0 - 2];
  after[0] = before.back();
  if (kept >= 1) after[1] = after[0] + n0 / n1 * a + off * any();
  if (kept >= 2) after[2] = 2.0 * after[1] - after[0] + n0 * (n0 - 1.0) / (n1 * (n1 - 1.0)) * (a - a2) + off * any();
  return {before, after};
}

}  // namespace

TEST_CASE("what control points show at a glance, a closer look finds, too", "[soundness]") {
  using enum Continuity;
  std::mt19937_64 random(7);
  int shown = 0, missed = 0;
  for (int i = 0; i < cases(40'000); ++i) {
    const double off = i % 4 == 0 ? 0.0 : std::pow(10.0, -17.0 + static_cast<double>(random() % 10));
    const auto [before, after] = pair_of(random, i % 3, off);
    const JointSides sides = sides_of(PolynomialSegment(before), PolynomialSegment(after), 0x1p-52);
    for (const Continuity claim : {g0, g1, g1_equal_magnitude, g2, c1, c2}) {
      const bool glance = plainly_keeps(before, after, claim, 1.0), look = !miss_of(sides, claim, 1.0);
      INFO("pair " << i << " claims " << name(claim) << ", off by " << off);
      CHECK((!glance || look));
      shown += glance ? 1 : 0;
      missed += look ? 0 : 1;
    }
  }
  CHECK(shown > cases(40'000));
  CHECK(missed > cases(40'000));
}
