#include "metrics/locality.hpp"

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"
#include "tests/unit/metrics/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

TEST_CASE("a polygon changes beside the moved point only", "[locality]") {
  const PolygonScheme polygon;
  for (const bool closed : {true, false}) {
    const Fit fit = polygon.fit(ring(10, closed));
    const LocalityProfile profile = locality_profile(polygon, fit, 0.05);
    CHECK(profile.fits == 80);
    CHECK(profile.failed == 0);
    REQUIRE(profile.influence.size() == (closed ? 5u : 9u));
    CHECK(profile.influence[0] == Approx(1.0).epsilon(1e-9));
    for (std::size_t i = 1; i < profile.influence.size(); ++i) CHECK(profile.influence[i] < 1e-12);
    CHECK(profile.reach(1e-6) == 1);
    CHECK(std::isnan(decay_per_span(profile)));
  }
}

TEST_CASE("influence in a uniform C2 spline decays by 2 - sqrt 3 a span", "[locality]") {
  const UniformSpline spline;
  // A regular polygon, so that all spans are alike; deviations along the curve do not matter to first order.
  Input input;
  input.closed = true;
  const int n = 24;
  for (int i = 0; i < n; ++i)
    input.points.emplace_back(std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n));
  const Fit fit = spline.fit(input);
  const LocalityProfile profile = locality_profile(spline, fit, 0.001);
  REQUIRE(profile.influence.size() == 12);
  const double factor = 2.0 - std::sqrt(3.0);
  for (std::size_t i = 2; i < 8; ++i) {
    CHECK(profile.influence[i] / profile.influence[i - 1] == Approx(factor).epsilon(0.02));
  }
  // Influence at distance d is about 0.29 * factor^(d - 1): the reaches follow.
  for (const double threshold : {1e-2, 1e-3, 1e-5}) {
    const int reach = profile.reach(threshold);
    CHECK(profile.influence[static_cast<std::size_t>(reach) - 1] > threshold);
    CHECK(profile.influence[static_cast<std::size_t>(reach)] <= threshold);
  }
}

TEST_CASE("decay is the slope of the logarithm", "[locality]") {
  CHECK(decay_per_span({0.01, {1.0, 0.1, 0.01, 0.001, 1e-15}, 1, 0}) == Approx(0.1).epsilon(1e-12));
  CHECK(std::isnan(decay_per_span({0.01, {1.0, 0.5}, 1, 0})));
}

TEST_CASE("the metric's columns: local scheme, refit equal to cold fit", "[locality]") {
  const PolygonScheme polygon;
  const Fit fit = polygon.fit(ring(8));
  for (const Measurement& m : find_metric("locality").measure(polygon, fit)) {
    if (m.column.rfind("locality_reach", 0) == 0 || m.column.rfind("locality_support", 0) == 0) CHECK(m.value == 1.0);
    if (m.column == "locality_refit_deviation") CHECK(m.value == 0.0);
    if (m.column == "locality_failed") CHECK(m.value == 0.0);
  }
}
