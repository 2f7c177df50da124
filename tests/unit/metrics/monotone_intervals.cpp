#include "metrics/monotone_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/curvature_profile.hpp"
#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

std::vector<ProfilePoint> plot(const std::vector<double>& values) {
  std::vector<ProfilePoint> points;
  for (const double v : values) points.push_back({{0, 0.0}, v, ProfilePoint::Kind::extremum});
  return points;
}

}  // namespace

TEST_CASE("turning points of a sequence", "[intervals]") {
  CHECK(turning_points(plot({0, 1, 2, 3}), 1.0).empty());
  CHECK(turning_points(plot({1, 1, 1}), 1.0).empty());
  CHECK(turning_points(plot({0, 2, 1}), 1.0).size() == 1);
  CHECK(turning_points(plot({0, 2, 2, 1}), 1.0).size() == 1);
  CHECK(turning_points(plot({0, 2, 1, 3, -1, 5}), 1.0).size() == 4);
  CHECK(turning_points(plot({0, 2, 1.95, 3, -1, 5}), 1.0, 0.1).size() == 2);
  CHECK(turning_points(plot({0, 2, 2 - 1e-12, 3}), 1.0).empty());
  const auto peak = turning_points(plot({0, 2, 1.95, 2.5, -1}), 1.0, 0.1);
  REQUIRE(peak.size() == 1);
  CHECK(peak[0].index == 3);
  CHECK(peak[0].maximum);
}

TEST_CASE("a parabola has two intervals, one extremum", "[intervals]") {
  const Fit fit = fit_of(single(bezier({{-1, 1}, {0, -1}, {1, 1}})));
  const Measurement m = measured(fit, "monotone_intervals", "intervals_per_segment_max");
  CHECK(m.value == 2.0);
  CHECK(m.method == Method::exact);
  CHECK(value(fit, "monotone_intervals", "intervals_per_centred_piece_max") == 2.0);
  CHECK(value(fit, "monotone_intervals", "curvature_extrema") == 1.0);
  CHECK(value(fit, "monotone_intervals", "prominent_extrema") == 1.0);
  CHECK(value(fit, "monotone_intervals", "segments_with_at_most_two_intervals") == 1.0);
}

TEST_CASE("an extremum at a joint counts for the curve, not for its segments", "[intervals]") {
  // y = x^2 cut at its vertex.
  const Curve cut({bezier({{-1, 1}, {-0.5, 0}, {0, 0}}), bezier({{0, 0}, {0.5, 0}, {1, 1}})}, {{0, Continuity::c2}},
                  {{0, 0, 0.0}, {1, 0, 1.0}, {2, 1, 1.0}}, false);
  const Fit fit = fit_of(cut);
  CHECK(value(fit, "monotone_intervals", "intervals_per_segment_max") == 1.0);
  CHECK(value(fit, "monotone_intervals", "intervals_per_centred_piece_max") == 2.0);
  CHECK(value(fit, "monotone_intervals", "curvature_extrema") == 1.0);
}

TEST_CASE("circles and straight lines have one interval and no extrema, wherever they lie", "[intervals]") {
  for (const double far : {0.0, 1e3, -1e5}) {
    const Fit fit = fit_of(circle(1.3, {far, 0.7 * far}));
    CHECK(value(fit, "monotone_intervals", "intervals_per_segment_max") == 1.0);
    CHECK(value(fit, "monotone_intervals", "intervals_per_centred_piece_max") == 1.0);
    CHECK(value(fit, "monotone_intervals", "curvature_extrema") == 0.0);
  }
  const Fit line = fit_of(single(bezier({{0, 0}, {1, 0.1}, {2, 0.2}, {3, 0.3}})));
  CHECK(value(line, "monotone_intervals", "intervals_per_segment_max") == 1.0);
  CHECK(value(line, "monotone_intervals", "curvature_extrema") == 0.0);
}

TEST_CASE("a closed curve has an even number of extrema; an ellipse of four parabolic arcs has its joints",
          "[intervals]") {
  // Four arcs that meet at points of greatest and least curvature.
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  const Vec2 p[] = {{2, 0}, {2, 1}, {0, 1}, {-2, 1}, {-2, 0}, {-2, -1}, {0, -1}, {2, -1}, {2, 0}};
  for (int i = 0; i < 4; ++i) {
    segments.push_back(bezier({p[2 * i], p[2 * i + 1], p[2 * i + 2]}));
    joints.push_back({i, Continuity::g1});
    nodes.push_back({i, i, 0.0});
  }
  const Fit fit = fit_of(Curve(segments, joints, nodes, true));
  const double extrema = value(fit, "monotone_intervals", "curvature_extrema");
  // Each parabola has its vertex inside (two intervals); the jumps of curvature at the joints on the x axis go
  // down from one peak and up to the next, as do those on the y axis.
  CHECK(value(fit, "monotone_intervals", "intervals_per_segment_max") == 2.0);
  CHECK(extrema == 8.0);
}

TEST_CASE("a cusp is one extremum, however rounding splits it", "[intervals]") {
  for (const double angle : {0.0, 0.3, 1.1, 2.2}) {
    std::vector<Vec2> points{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
    for (Vec2& q : points) {
      q = Vec2(std::cos(angle) * q.x() - std::sin(angle) * q.y(), std::sin(angle) * q.x() + std::cos(angle) * q.y());
    }
    const Fit fit = fit_of(single(bezier(points)));
    CHECK(value(fit, "monotone_intervals", "curvature_extrema") == 1.0);
    CHECK(value(fit, "monotone_intervals", "intervals_per_segment_max") == 2.0);
  }
}

TEST_CASE("curvature near a cusp is what it is, at a cusp infinite", "[intervals]") {
  const auto profile_of = [](double e) {
    return curvature_profile(single(bezier({{0, 0}, {1 + e, 1}, {-e, 1}, {1, 0}})), 0x1p-52);
  };
  for (const double e : {1e-3, 1e-5, 1e-6, 1e-7}) {
    // At t = 1/2: c' = (-3 e / 2, 0), c'' = (0, -6), so that kappa = 6 / |c'|^2 up to its sign.
    const double expected = 6.0 / (2.25 * e * e);
    const CurvatureProfile profile = profile_of(e);
    double most = 0.0;
    for (const ProfilePoint& point : profile.points) most = std::max(most, std::abs(point.curvature));
    CHECK(most == Approx(expected).epsilon(1e-6));
  }
  const CurvatureProfile cusp = profile_of(0.0);
  CHECK(std::isinf(cusp.points[1].curvature));
  CHECK(std::isfinite(cusp.range));
  CHECK(turning_points(cusp, false).size() == 1);
}
