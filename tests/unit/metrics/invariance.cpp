#include "metrics/invariance.hpp"

#include <cmath>

#include "metrics/correspondence.hpp"
#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"
#include "tests/unit/metrics/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

double of(const Scheme& scheme, const Input& input, std::string_view metric, std::string_view column) {
  for (const Measurement& m : find_metric(metric).measure(scheme, scheme.fit(input))) {
    if (m.column == column) return m.value;
  }
  throw std::logic_error("no column " + std::string(column));
}

const char* const deviations[] = {"deviation_similarity", "deviation_mirror", "deviation_reversal"};

}  // namespace

TEST_CASE("a polygon is invariant in every respect", "[invariance]") {
  const PolygonScheme polygon;
  for (const bool closed : {true, false}) {
    const Input input = ring(9, closed);
    for (const char* column : deviations) CHECK(of(polygon, input, "invariance", column) < 1e-13);
    CHECK(of(polygon, input, "invariance", "deviation_extensionality_max") < 1e-13);
    CHECK(of(polygon, input, "invariance", "sensitivity") == Approx(1.0).epsilon(1e-4));
  }
  CHECK(of(polygon, ring(9), "invariance", "deviation_cyclic_shift") < 1e-14);
  CHECK(std::isnan(of(polygon, ring(9, false), "invariance", "deviation_cyclic_shift")));
}

TEST_CASE("a bias in y breaks similarity and mirroring by its size, not reversal", "[invariance]") {
  const PolygonScheme biased(0.05);
  const Input input = ring(9);
  CHECK(of(biased, input, "invariance", "deviation_similarity") * mean_chord(input) > 0.015);
  // Up against down: the bulge of a quadratic is half the bias, and the arc-length samples move a little along.
  CHECK(of(biased, input, "invariance", "deviation_mirror") * mean_chord(input) == Approx(0.05).epsilon(0.1));
  CHECK(of(biased, input, "invariance", "deviation_reversal") < 1e-13);
  CHECK(of(biased, input, "invariance", "deviation_cyclic_shift") < 1e-14);
  CHECK(of(biased, input, "invariance", "deviation_extensionality_max") > 1e-3);
}

TEST_CASE("a C2 spline is similarity invariant but not extensional", "[invariance]") {
  const UniformSpline spline;
  const Input input = ring(11);
  for (const char* column : deviations) CHECK(of(spline, input, "invariance", column) < 1e-12);
  CHECK(of(spline, input, "invariance", "deviation_cyclic_shift") < 1e-12);
  CHECK(of(spline, input, "invariance", "deviation_extensionality_max") > 1e-3);
  CHECK(of(spline, input, "invariance", "sensitivity") < 5.0);
}

TEST_CASE("roundness of polygons is that of their edges", "[invariance]") {
  const PolygonScheme polygon;
  CHECK(of(polygon, ring(5), "roundness", "roundness_4") == Approx(1.0 - std::sqrt(0.5)).epsilon(1e-12));
  CHECK(of(polygon, ring(5), "roundness", "roundness_3") == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("spans start and end at nodes and are matched around a closed curve", "[invariance]") {
  const PolygonScheme polygon;
  const Input input = ring(6);
  const std::vector<Span> a = spans(*polygon.fit(input).curve);
  REQUIRE(a.size() == 6);
  CHECK(a[2].from == 2);
  CHECK(a[5].to == 0);
  CHECK((a[3].samples.front() - input.points[3]).norm() < 1e-15);
  CHECK((a[3].samples.back() - input.points[4]).norm() < 1e-15);
  std::vector<Span> b(a.begin() + 2, a.end());
  b.insert(b.end(), a.begin(), a.begin() + 2);
  CHECK(deviation(a, b, true) == 0.0);
  CHECK(std::isinf(deviation(a, b, false)));
  CHECK(std::isinf(deviation(a, reversed(a), true)));
}

TEST_CASE("even choice", "[invariance]") {
  CHECK(tried(3) == std::vector<int>{0, 1, 2});
  CHECK(tried(60).size() == 60);
  CHECK(tried(120) == std::vector<int>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110});
  CHECK(tried(0).empty());
}
