// Near-cusps between the nodes of a quadrature rule, found by the polynomial itself.
#include "schemes/pkappa/near_cusp.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::pkappa;
using namespace kappabench::test;

namespace {

/// The same curve with one control point more.
template <int Degree>
ControlPolygon<Degree + 1> elevated(const ControlPolygon<Degree>& c) {
  ControlPolygon<Degree + 1> result;
  for (int i = 0; i <= Degree + 1; ++i) {
    const double share = static_cast<double>(i) / (Degree + 1);
    result.col(i) = Vec2::Zero();
    if (i > 0) result.col(i) += share * c.col(i - 1);
    if (i <= Degree) result.col(i) += (1.0 - share) * c.col(i);
  }
  return result;
}

/// c' = (speed, t - at): slowest at `at`, where it turns within `speed`.
ControlPolygon<2> bend(double speed, double at) {
  ControlPolygon<2> c;
  c << 0.0, 0.5 * speed, speed, 0.0, -0.5 * at, 0.5 - at;
  return c;
}

}  // namespace

TEST_CASE("pkappa: a near-cusp is found where it is, however narrow, and only if it is narrow") {
  for (const double at : {0.1, 1.0 / 3.0, 0.5, 0.77})
    for (const double speed : {1e-2, 3e-3, 1e-3, 1e-6, 1e-12, 0.0})
      for (const double width : {1.0 / 64, 1.0 / 256}) {
        INFO("at " << at << ", speed " << speed << ", width " << width);
        const auto quartic = elevated<3>(elevated<2>(bend(speed, at)));
        for (const auto& found : {near_cusp<4>(quartic, width), near_cusp<5>(elevated<4>(quartic), width)}) {
          REQUIRE(found.has_value() == (speed < width));
          if (found) CHECK(*found == Approx(at).margin(1e-8));
        }
      }
}

TEST_CASE("pkappa: half a near-cusp at an end is one, slow along a line is none") {
  // c' = (1e-5 + t, 0) and c' = (1e-5, t): both are slowest at t = 0.
  ControlPolygon<2> line, end;
  line << 0.0, 0.5e-5, 0.5 + 1e-5, 0.0, 0.0, 0.0;
  end << 0.0, 0.5e-5, 1e-5, 0.0, 0.0, 0.5;
  CHECK_FALSE(near_cusp<4>(elevated<3>(elevated<2>(line)), 1.0 / 256));
  CHECK(near_cusp<4>(elevated<3>(elevated<2>(end)), 1.0 / 256));
}

TEST_CASE("pkappa: a segment that all but stops without turning is seen where the speed has a floor") {
  // c' = (floor + (t - 1/3)^2, 0).
  for (const double speed : {2e-5, 5e-6}) {
    INFO(speed);
    ControlPolygon<3> line = ControlPolygon<3>::Zero();
    const double edges[] = {speed + 1.0 / 9.0, speed + 1.0 / 9.0 - 1.0 / 3.0, speed + 4.0 / 9.0};
    for (int i = 0; i < 3; ++i) line(0, i + 1) = line(0, i) + edges[i] / 3.0;
    const auto found = near_cusp<4>(elevated<3>(line), 0.0, 1e-5);
    REQUIRE(found.has_value() == (speed < 1e-5));
    if (found) CHECK(*found == Approx(1.0 / 3.0).margin(1e-8));
  }
}

TEST_CASE("pkappa: a curve with a hidden near-cusp is not converged, and says where") {
  // A dove's outline; between points 9 and 11 quartics of the whole curve have such a minimum.
  const Input dove{.points = {{3, 51},
                              {11, 58},
                              {19, 60},
                              {28, 54},
                              {37, 54},
                              {40, 74},
                              {57, 97},
                              {61, 74},
                              {63, 55},
                              {76, 50},
                              {98, 58},
                              {89, 48},
                              {97, 38},
                              {73, 38},
                              {67, 27},
                              {66, 4},
                              {50, 24},
                              {31, 34},
                              {14, 44}},
                   .closed = true};
  for (const char* text :
       {"pkappa:mode=global,continuity=g1", "pkappa:mode=global,continuity=c1", "pkappa:continuity=g1"}) {
    INFO(text);
    const Fit fit = scheme(text)->fit(dove);
    REQUIRE(fit.curve.has_value());
    int hidden = 0;
    for (const SegmentPtr& segment : fit.curve->segments()) {
      const PolynomialForm form = std::get<PolynomialForm>(segment->exact());
      ControlPolygon<4> control;
      for (int i = 0; i <= 4; ++i) control.col(i) = form.control_points[static_cast<std::size_t>(i)];
      hidden += near_cusp<4>(control, 1.0 / 256).has_value();
    }
    CHECK((fit.report.outcome == Outcome::converged) == (hidden == 0));
    CHECK((fit.report.message.find("near-cusp at t = ") != std::string::npos) == (hidden > 0));
  }
}
