// What the metrics say about trigonometric blending and clothoid splines, against what these schemes claim.
#include <string>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"
#include "metrics/metric.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

double measured(std::string_view metric, std::string_view column, const Scheme& scheme, const Input& input) {
  const Fit fit = scheme.fit(input);
  REQUIRE(fit.curve.has_value());
  for (const Measurement& m : find_metric(metric).measure(scheme, fit))
    if (m.column == column) return m.value;
  FAIL("no column " << column);
  return 0.0;
}

const Input bird = open_drawings("bird").front().curves.front();

}  // namespace

TEST_CASE("the kinks of clothoid, line, clothoid show in the continuity metric; three arcs and blends have none") {
  const SchemePtr clc = scheme("clothoid3:pieces=clc");
  const double kink = measured("continuity", "continuity_angle_jump", *clc, bird);
  CHECK(kink > 1e-3);
  CHECK(kink < 0.02001);
  CHECK(measured("continuity", "continuity_violations", *clc, bird) > 0.0);
  CHECK_THAT(clc->info().traits.continuity_exceptions, ContainsSubstring("kinks of up to 0.01 rad"));
  for (const std::string_view text :
       {"clothoid3", "clothoid3:curvature=conic", "clothoid3:refine=false", "yuksel", "yuksel:arc=bezier",
        "yuksel:arc=circular", "yuksel:arc=elliptical", "yuksel:parametrization=c2",
        "yuksel:arc=bezier,parametrization=c2", "hobby", "euler-spiral"}) {
    INFO(text);
    CHECK(measured("continuity", "continuity_violations", *scheme(text), bird) == 0.0);
    CHECK(measured("continuity", "continuity_angle_jump", *scheme(text), bird) < 1e-12);
  }
  CHECK(measured("continuity", "continuity_second_derivative_jump", *scheme("yuksel:parametrization=c2"), bird) <
        1e-11);
}

TEST_CASE("the support that the locality metric measures is the one that the traits claim") {
  const Input input = random_input(RandomKind::walk, 12, 3, true);
  for (const std::string_view text : {"yuksel", "clothoid3", "clothoid3:curvature=conic,refine=false"}) {
    const SchemePtr tested = scheme(text);
    INFO(text);
    CHECK(measured("locality", "locality_support_move_5pct", *tested, input) == tested->info().traits.locality);
  }
}
