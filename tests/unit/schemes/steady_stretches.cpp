#include "schemes/curve/steady_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"

using namespace kappabench;

namespace {

/// `most_ratio` of the largest speed to the least.
void check_steady(const Segment& segment, double most_ratio = 3.0) {
  const std::vector<double> ends = steady_stretches(segment);
  REQUIRE(ends.size() >= 2);
  CHECK(ends.front() == 0.0);
  CHECK(ends.back() == 1.0);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    REQUIRE(ends[i] < ends[i + 1]);
    const Vec2 first = segment.jet(ends[i], 1).d[1];
    double least = first.norm(), most = least, turned = 0.0;
    for (int k = 1; k <= 20; ++k) {
      const Vec2 v = segment.jet(ends[i] + (ends[i + 1] - ends[i]) * k / 20.0, 1).d[1];
      least = std::min(least, v.norm());
      most = std::max(most, v.norm());
      turned = std::max(turned, std::abs(std::atan2(cross(first, v), first.dot(v))));
    }
    CHECK(most <= (most_ratio + 1e-9) * least);
    CHECK(turned <= std::numbers::pi / 3.0 + 1e-9);
  }
}

}  // namespace

TEST_CASE("on a steady stretch speed and direction vary little", "[steady]") {
  for (const double e : {1.0, 1e-2, 1e-4, 1e-6}) {  // u, e + u^2: near-cusps
    check_steady(
        PolynomialSegment(std::vector<Vec2>{{3, -1 - 12 * e}, {-1, 1 - 4 * e}, {-1, -1 + 4 * e}, {3, 1 + 12 * e}}));
  }
  check_steady(PolynomialSegment(std::vector<Vec2>{{0, 0}, {4, 3}, {-2, 3}, {1, 1}, {5, -2}, {3, 0}}));
  check_steady(TrigonometricSegment({Vec2{0, 0}, {1, 0}, {0.9, 1.1}, {1.2, 0.3}, {0, 0.4}}), 12.0);
  check_steady(EllipticArcSegment({{0, 0}, {3, 0.2}, {0.1, 0.2}, -1.0, 4.0}));
}

TEST_CASE("steady stretches are geometric towards a cusp, and one where the speed is constant", "[steady]") {
  const PolynomialSegment cusp(std::vector<Vec2>{{0, 0}, {1, 1}, {0, 1}, {1, 0}});
  const std::vector<double> ends = steady_stretches(cusp);
  CHECK(ends.size() > 60);
  CHECK(ends.size() < 250);
  CHECK(std::ranges::is_sorted(ends));
  CHECK(steady_stretches(ClothoidSegment({{0, 0}, 0.0, 40.0, -80.0, 1.0})).size() == 2);
}
