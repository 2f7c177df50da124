#include "schemes/api/find_nodes.hpp"

#include "datasets/datasets.hpp"
#include "schemes/segments/polynomial.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

SegmentPtr line(Vec2 from, Vec2 to) { return std::make_shared<PolynomialSegment>(std::vector<Vec2>{from, to}); }

Vec2 at(const Curve& curve, const Node& node) { return curve.segment(node.segment).jet(node.t, 0).position(); }

/// The curves of a built-in drawing.
std::vector<Input> curves_of(const char* drawing) { return open_drawings(drawing).front().curves; }

}  // namespace

TEST_CASE("the nodes of every scheme are found again from its segments alone") {
  for (const SchemeInfo& info : all_schemes().list())
    for (const char* drawing : {"bird", "figure-eight", "toy", "hairpin"})
      for (const Input& input : curves_of(drawing)) {
        INFO(info.id << " on " << drawing);
        const Fit fit = scheme(info.id)->fit(input);
        if (!fit.curve || fit.report.outcome != Outcome::converged) continue;
        const std::vector<Node> found = find_nodes(fit.curve->segments(), input.closed, input.points);
        REQUIRE(found.size() == input.points.size());
        const double chord = mean_chord(input);
        for (const Node& node : found) {
          const Vec2& p = input.points[static_cast<std::size_t>(node.point)];
          CHECK((at(*fit.curve, node) - p).norm() <= 1e-9 * chord);
        }
        // A scheme that gives each point one node has them in the same places.
        if (fit.curve->nodes().size() != found.size()) continue;
        for (std::size_t i = 0; i < found.size(); ++i) {
          const Node &known = fit.curve->nodes()[i], &here = found[i];
          const bool same = known.segment == here.segment && std::abs(known.t - here.t) <= 1e-6;
          CHECK((same || (at(*fit.curve, known) - at(*fit.curve, here)).norm() <= 1e-12 * chord));
        }
      }
}

TEST_CASE("a crossing is passed twice, and the order of the points tells which is which") {
  // A bow tie: both diagonals pass the middle.
  const std::vector<SegmentPtr> tie{line({0, 0}, {2, 2}), line({2, 2}, {2, 0}), line({2, 0}, {0, 2}),
                                    line({0, 2}, {0, 0})};
  const std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}};
  const std::vector<Node> nodes = find_nodes(tie, true, points);
  REQUIRE(nodes.size() == 6);
  const std::vector<int> segments{0, 0, 1, 2, 2, 3};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    CHECK(nodes[i].point == static_cast<int>(i));
    CHECK(nodes[i].segment == segments[i]);
  }
  CHECK(nodes[1].t == Approx(0.5).margin(1e-15));
  // The same, entered elsewhere.
  const std::vector<Vec2> shifted{{2, 0}, {1, 1}, {0, 2}, {0, 0}, {1, 1}, {2, 2}};
  const std::vector<Node> again = find_nodes(tie, true, shifted);
  CHECK(again[1].segment == 2);
  CHECK(again[4].segment == 0);
}

TEST_CASE("points off the curve are nearest where they are nearest, in whatever order") {
  const std::vector<SegmentPtr> path{line({0, 0}, {4, 0}), line({4, 0}, {4, 4})};
  const std::vector<Vec2> points{{5, 3}, {1, -1}};
  const std::vector<Node> nodes = find_nodes(path, false, points);
  REQUIRE(nodes.size() == 2);
  CHECK(nodes[0].segment == 1);
  CHECK(nodes[0].t == Approx(0.75));
  CHECK(nodes[1].segment == 0);
  CHECK(nodes[1].t == Approx(0.25));
}

TEST_CASE("joints and ends are joints and ends, far from the origin too") {
  for (const double far : {0.0, 1e9}) {
    const Vec2 o(far, -far);
    const std::vector<SegmentPtr> path{line(o, o + Vec2(1, 0)), line(o + Vec2(1, 0), o + Vec2(1, 1))};
    const std::vector<Vec2> points{o, o + Vec2(1, 0), o + Vec2(1, 1)};
    const std::vector<Node> open = find_nodes(path, false, points);
    REQUIRE(open.size() == 3);
    CHECK((open[0].segment == 0 && open[0].t == 0.0));
    CHECK((open[1].segment == 1 && open[1].t == 0.0));
    CHECK((open[2].segment == 1 && open[2].t == 1.0));
  }
}

TEST_CASE("nothing to find gives nothing") {
  const std::vector<SegmentPtr> path{line({0, 0}, {1, 0})};
  CHECK(find_nodes(path, false, {}).empty());
  CHECK(find_nodes({}, false, std::vector<Vec2>{{0, 0}}).empty());
  CHECK(find_nodes(path, false, std::vector<Vec2>{{std::nan(""), 0}}).empty());
}
