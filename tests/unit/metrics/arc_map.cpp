#include "metrics/arc_map.hpp"

#include <cmath>
#include <numbers>

#include "metrics/arc_samples.hpp"
#include "metrics/node_pieces.hpp"
#include "tests/catch.hpp"
#include "tests/unit/metrics/curves.hpp"

using namespace kappabench;
using namespace kappabench::test;

TEST_CASE("arc length of a circle, and back", "[arc]") {
  const Curve curve = circle(2.0, {10.0, -3.0});
  const ArcMap arcs(curve);
  const double length = 4.0 * std::numbers::pi;
  CHECK(arcs.length() == Approx(length).epsilon(1e-13));
  CHECK(arcs.position({2, 0.5}) == Approx(0.625 * length).epsilon(1e-13));
  for (int k = 0; k < 50; ++k) {
    const double s = length * k / 50.0;
    CHECK(std::abs(arcs.position(arcs.place(s)) - s) < 1e-12);
    const CurvePlace around = arcs.place(s + arcs.length());
    CHECK(std::abs(arcs.position(around) - s) < 1e-11);
  }
}

TEST_CASE("arc length through a cusp and from a point of rest", "[arc]") {
  // (t^2, t^3) type cusp in the middle: both halves are equal by symmetry.
  const Curve cusp = single(bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}));
  const ArcMap arcs(cusp);
  CHECK(arcs.position({0, 0.5}) == Approx(0.5 * arcs.length()).epsilon(1e-12));
  for (int k = 1; k < 20; ++k) {
    const double s = arcs.length() * k / 20.0;
    CHECK(std::abs(arcs.position(arcs.place(s)) - s) < 1e-12);
  }
  // x = t^2: rests at its start.
  const Curve resting = single(bezier({{0, 0}, {0, 0}, {1, 0}}));
  CHECK(ArcMap(resting).position({0, 1e-3}) == Approx(1e-6).epsilon(1e-9));
  CHECK(ArcMap(resting).place(1e-6).t == Approx(1e-3).epsilon(1e-6));
}

TEST_CASE("samples integrate functions of arc length", "[arc]") {
  // y = x^2 on [-1, 1].
  const SegmentPtr parabola = bezier({{-1, 1}, {0, -1}, {1, 1}});
  const double length = std::sqrt(5.0) + 0.5 * std::asinh(2.0);
  double sum = 0.0;
  double moment = 0.0;
  double before = 0.0;
  for (const ArcSample& sample : arc_samples(*parabola, 0.0, 1.0)) {
    sum += sample.weight;
    moment += sample.weight * sample.s;
    CHECK(sample.s > before);
    before = sample.s;
  }
  CHECK(sum == Approx(length).epsilon(1e-14));
  CHECK(moment == Approx(0.5 * length * length).epsilon(1e-13));
}

TEST_CASE("centred pieces cover a closed curve once", "[arc]") {
  const Curve curve = circle(1.0);
  const ArcMap arcs(curve);
  double covered = 0.0;
  for (const CentredPiece& piece : centred_pieces(curve, arcs)) {
    for (const Part& part : piece.parts) {
      covered += arcs.position({part.segment, part.t1}) - arcs.position({part.segment, part.t0});
    }
    CHECK(piece.end - piece.start == Approx(0.5 * std::numbers::pi));
  }
  CHECK(covered == Approx(arcs.length()).epsilon(1e-12));
}

TEST_CASE("an open curve that lists only its inner points has pieces for all of them", "[arc]") {
  const Curve curve({bezier({{-1, 1}, {0, -1}, {1, 1}})}, {}, {{1, 0, 0.5}}, false);
  const ArcMap arcs(curve);
  const auto pieces = centred_pieces(curve, arcs);
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0].start == Approx(0.25 * arcs.length()));
  CHECK(pieces[0].end == Approx(0.75 * arcs.length()));
}
