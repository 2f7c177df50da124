#include "metrics/features.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "metrics/self_intersection.hpp"
#include "schemes/segments/blend.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/reparametrized.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// Crossings of the polygon through `per_segment` points of each segment, all pairs.
int polygon_crossings(const Curve& curve, int per_segment) {
  std::vector<Vec2> p;
  for (const SegmentPtr& segment : curve.segments()) {
    for (int i = 0; i < per_segment; ++i) p.push_back(segment->jet(static_cast<double>(i) / per_segment, 0).position());
  }
  p.push_back(curve.closed() ? p.front() : curve.end());
  int count = 0;
  const std::size_t n = p.size() - 1;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (curve.closed() && i == 0 && j + 1 == n) continue;
      const Vec2 a = p[i + 1] - p[i];
      const Vec2 b = p[j + 1] - p[j];
      const bool of_a = (cross(a, p[j] - p[i]) > 0) != (cross(a, p[j + 1] - p[i]) > 0);
      const bool of_b = (cross(b, p[i] - p[j]) > 0) != (cross(b, p[i + 1] - p[j]) > 0);
      if (of_a && of_b) ++count;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("a looped cubic has one crossing, where its symmetry says", "[features]") {
  const Curve curve = single(bezier({{0, 0}, {3, 2}, {-2, 2}, {1, 0}}));
  const Crossings crossings = self_intersections(curve);
  REQUIRE(crossings.complete);
  REQUIRE(crossings.found.size() == 1);
  CHECK(crossings.found[0].position.x() == Approx(0.5));
  CHECK(crossings.found[0].first.t + crossings.found[0].second.t == Approx(1.0));
  const Fit fit = fit_of(curve);
  CHECK(value(fit, "features", "loops") == 1.0);
  CHECK(value(fit, "features", "loops_at_nodes") == 0.0);
  CHECK(value(fit, "features", "inflections") == 0.0);

  const double t = crossings.found[0].first.t;
  const Curve noded({bezier({{0, 0}, {3, 2}, {-2, 2}, {1, 0}})}, {}, {{0, 0, 0}, {1, 0, t}, {1, 0, 1 - t}, {2, 0, 1}},
                    false);
  CHECK(value(fit_of(noded), "features", "loops_at_nodes") == 1.0);
}

TEST_CASE("inflections inside, at a node, and at a joint", "[features]") {
  const std::vector<Vec2> s{{0, 0}, {1, 1}, {2, -1}, {3, 0}};
  CHECK(value(fit_of(single(bezier(s), 0.2)), "features", "inflections") == 1.0);
  CHECK(value(fit_of(single(bezier(s), 0.2)), "features", "inflections_at_nodes") == 0.0);
  CHECK(value(fit_of(single(bezier(s), 0.5)), "features", "inflections_at_nodes") == 1.0);
  const SegmentPtr a = bezier({{0, 0}, {1, 1}, {2, 0}});
  const SegmentPtr b = bezier({{2, 0}, {3, -1}, {4, 0}});
  const Fit joint =
      fit_of(Curve({a, b}, {{0, Continuity::g1_equal_magnitude}}, {{0, 0, 0}, {1, 0, 0.5}, {2, 1, 1}}, false));
  CHECK(value(joint, "features", "inflections") == 1.0);
  CHECK(value(joint, "features", "inflections_at_joints") == 1.0);
  // A straight line between two arcs that bend to opposite sides.
  const Fit line =
      fit_of(Curve({bezier({{0, 1}, {0, 0}, {1, 0}}), bezier({{1, 0}, {2, 0}}), bezier({{2, 0}, {3, 0}, {3, -1}})},
                   {{0, Continuity::g1}, {1, Continuity::g1}}, {{0, 0, 0}, {1, 1, 0.5}, {2, 2, 1}}, false));
  CHECK(value(line, "features", "inflections") == 1.0);
}

TEST_CASE("a cubic with an inflection at its joint, spoilt by rounding, has one", "[features]") {
  // y = x^3 cut at 0 and turned: rounding may move the inflection to either side, or to both.
  for (int k = 0; k < 40; ++k) {
    const double c = std::cos(0.1 * k);
    const double s = std::sin(0.1 * k);
    const auto turned = [&](std::vector<Vec2> points) {
      for (Vec2& p : points) p = Vec2(c * p.x() - s * p.y() + 0.3, s * p.x() + c * p.y() - 0.7);
      return bezier(points);
    };
    const Vec2 third(1.0 / 3.0, 0);
    const Curve curve({turned({{-1, -1}, -2 * third, -1 * third, {0, 0}}), turned({{0, 0}, third, 2 * third, {1, 1}})},
                      {{0, Continuity::c2}}, {{0, 0, 0}, {1, 0, 1}, {2, 1, 1}}, false);
    CHECK(value(fit_of(curve), "features", "inflections") == 1.0);
  }
}

TEST_CASE("an inflection counts if the curvature is more than rounding on both sides", "[features]") {
  // (t, t^3 - 3 e t^2) inflects at t = e, and bends by -6 e at its start.
  const auto count = [](double e) {
    const Fit fit = fit_of(single(bezier({{0, 0}, {1.0 / 3.0, 0}, {2.0 / 3.0, -e}, {1, 1 - 3 * e}})));
    return value(fit, "features", "inflections");
  };
  for (const double e : {1e-1, 1e-3, 1e-6, 1e-9}) CHECK(count(e) == 1.0);
  for (const double e : {3e-16, 1e-16, 0.0, -1e-3}) CHECK(count(e) == 0.0);
}

TEST_CASE("short segments keep their inflections", "[features]") {
  // An S of a thousandth of a millionth of the curve's length between two straight lines.
  const double d = 1e-9;
  const Curve curve(
      {bezier({{-1, 0}, {0, 0}}), bezier({{0, 0}, {d, d}, {2 * d, -d}, {3 * d, 0}}), bezier({{3 * d, 0}, {1, 0}})},
      {{0, Continuity::g0}, {1, Continuity::g0}}, {{0, 0, 0}, {1, 2, 1}}, false);
  CHECK(value(fit_of(curve), "features", "inflections") == 1.0);
}

TEST_CASE("the number of inflections and cusps says how it is known", "[features]") {
  const SegmentPtr parabola = bezier({{-1, 1}, {0, -1}, {1, 1}});
  const auto arc =
      std::make_shared<EllipticArcSegment>(EllipticArcForm{{0, 0}, {1, 0}, {0, 0.5}, std::numbers::pi, 0.0});
  const auto method = [](const SegmentPtr& segment, const char* column) {
    return measured(fit_of(single(segment)), "features", column).method;
  };
  const auto blend = std::make_shared<BlendSegment>(parabola, arc);
  for (const char* column : {"inflections", "cusps"}) {
    CHECK(method(parabola, column) == Method::exact);
    CHECK(method(arc, column) == Method::exact);
    CHECK(method(std::make_shared<ReparametrizedSegment>(arc, 2.0), column) == Method::exact);
    CHECK(method(blend, column) == Method::enclosed);
    CHECK(method(std::make_shared<ReparametrizedSegment>(blend, 2.0), column) == Method::enclosed);
  }
  // Nothing is proved of a circle that is blended with itself.
  const auto circle = std::make_shared<ClothoidSegment>(ClothoidForm{{0, 0}, 0.0, 1.0, 0.0, 1.0});
  CHECK(measured(fit_of(single(std::make_shared<BlendSegment>(circle, circle))), "monotone_intervals",
                 "curvature_extrema")
            .method == Method::sampled);
}

TEST_CASE("cusps: inside a segment and at a joint", "[features]") {
  const Fit inside = fit_of(single(bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}), 0.5));
  CHECK(value(inside, "features", "cusps") == 1.0);
  CHECK(value(inside, "features", "cusps_at_nodes") == 1.0);
  CHECK(value(inside, "features", "loops") == 0.0);
  const Curve spike({bezier({{0, 0}, {1, 0}, {1, 1}}), bezier({{1, 1}, {1, 0}, {2, 0}})}, {{0, Continuity::g0}},
                    {{0, 0, 0}, {1, 0, 0.5}, {2, 1, 1}}, false);
  CHECK(value(fit_of(spike), "features", "cusps") == 1.0);
  CHECK(value(fit_of(spike), "features", "cusps_at_joints") == 1.0);
  CHECK(value(fit_of(spike), "features", "loops") == 0.0);
}

TEST_CASE("circles and lines have no features", "[features]") {
  for (const char* column : {"inflections", "cusps", "loops"}) {
    CHECK(value(fit_of(circle(2.0, {100, 3})), "features", column) == 0.0);
    CHECK(value(fit_of(single(bezier({{0, 0}, {1, 0.1}, {2, 0.2}, {3, 0.3}}))), "features", column) == 0.0);
  }
}

TEST_CASE("a curve that runs back over itself has no countable loops", "[features]") {
  const Curve back({bezier({{0, 0}, {1, 1}, {2, 0}}), bezier({{2, 0}, {1, 1}, {0, 0}})},
                   {{0, Continuity::g0}, {1, Continuity::g0}}, {{0, 0, 0.5}, {1, 1, 0.2}}, true);
  CHECK(std::isnan(value(fit_of(back), "features", "loops")));
}

TEST_CASE("crossings agree with those of a fine polygon on random curves", "[features]") {
  std::mt19937 random(99);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  int total = 0;
  for (int trial = 0; trial < test::cases(150); ++trial) {
    // Closed or open chains of cubics with matching tangents.
    const bool closed = trial % 2 == 0;
    const int n = 2 + trial % 4;
    std::vector<Vec2> points;
    std::vector<Vec2> tangents;
    for (int i = 0; i <= n; ++i) {
      points.emplace_back(coordinate(random), coordinate(random));
      tangents.emplace_back(coordinate(random), coordinate(random));
    }
    if (closed) {
      points.back() = points.front();
      tangents.back() = tangents.front();
    }
    std::vector<SegmentPtr> segments;
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      segments.push_back(bezier({points[i], points[i] + tangents[i], points[i + 1] - tangents[i + 1], points[i + 1]}));
      if (closed || i + 1 < static_cast<std::size_t>(n)) joints.push_back({static_cast<int>(i), Continuity::c1});
    }
    const Curve curve(segments, joints, {}, closed);
    const Crossings crossings = self_intersections(curve);
    CHECK(crossings.complete);
    CHECK(static_cast<int>(crossings.found.size()) == polygon_crossings(curve, 400));
    total += static_cast<int>(crossings.found.size());
    for (const Crossing& c : crossings.found) {
      const Vec2 a = curve.segment(c.first.segment).jet(c.first.t, 0).position();
      const Vec2 b = curve.segment(c.second.segment).jet(c.second.t, 0).position();
      CHECK((a - b).norm() < 1e-12);
    }
  }
  CHECK(total > test::cases(150));
}

TEST_CASE("inflections of a closed eight are found at the closure as well", "[features]") {
  // Two lobes that bend to opposite sides and meet, smoothly, in the crossing.
  const SegmentPtr right = bezier({{0, 0}, {4, 4}, {4, -4}, {0, 0}});
  const SegmentPtr left = bezier({{0, 0}, {-4, 4}, {-4, -4}, {0, 0}});
  const Curve eight({right, left}, {{0, Continuity::g1}, {1, Continuity::g1}}, {{0, 0, 0.5}, {1, 1, 0.5}}, true);
  const ArcMap arcs(eight);
  const std::vector<double> found = find_inflections(eight, arcs, 0x1p-52).positions;
  REQUIRE(found.size() == 2);
  CHECK(found[0] == 0.0);
  CHECK(found[1] == Approx(0.5 * arcs.length()));
  CHECK(value(fit_of(eight), "features", "inflections_at_joints") == 2.0);
  // The crossing is at the joints, passed twice.
  CHECK(value(fit_of(eight), "features", "loops") == 1.0);
  CHECK(value(fit_of(eight), "features", "loops_at_joints") == 1.0);
}
