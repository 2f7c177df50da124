// Curves that were made elsewhere, as a scheme: which of a file's curves the points belong to, where its nodes are, and
// what is said of it when it misses them.
#include "datasets/curves/given_curves.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <vector>

#include "schemes/api/curve_json.hpp"
#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;

namespace {

GivenCurves given(const std::string& content, const std::string& name = "mine.svg") {
  const ScratchFolder folder;
  return {name, read_curve_file(file_in(folder, name, content))};
}
GivenCurves path(const std::string& data) { return given("<svg><path d='" + data + "'/></svg>"); }

/// y upwards.
Input points(std::vector<Vec2> at, bool closed = false) { return {.points = std::move(at), .closed = closed}; }

std::string places(const Fit& fit) {
  std::string text;
  for (const Node& node : fit.curve->nodes()) text += fmt::format("{}:{}+{:.3g} ", node.point, node.segment, node.t);
  return text;
}
std::string claims(const Fit& fit) {
  std::string text;
  for (const Joint& joint : fit.curve->joints()) text += fmt::format("{} ", name(joint.claimed));
  return text;
}

}  // namespace

TEST_CASE("given curves: own points are the vertices", "[given]") {
  const GivenCurves open = path("M0 0L2 0L2 -2");
  REQUIRE(open.curves().size() == 1);
  const Input& own = open.curves()[0].own;
  CHECK_FALSE(own.closed);
  CHECK(own.points == std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}});
  const Fit fit = open.fit(own);
  CHECK(fit.report.outcome == Outcome::converged);
  CHECK(places(fit) == "0:0+0 1:1+0 2:1+1 ");
  CHECK(fit.report.residual == 0.0);

  const GivenCurves closed = path("M0 0L2 0L2 -2z");
  CHECK(closed.curves()[0].own.closed);
  CHECK(places(closed.fit(closed.curves()[0].own)) == "0:0+0 1:1+0 2:2+0 ");
  // Without z too, if the ends meet.
  CHECK(path("M0 0L2 0L2 -2L0 0").curves()[0].own.closed);
}

TEST_CASE("given curves: joints claim what is found", "[given]") {
  // A half circle, the line along its tangent, a corner.
  const GivenCurves curve = path("M0 0A1 1 0 0 1 2 0V3H5C6 3 7 3 8 4");
  const Fit fit = curve.fit(curve.curves()[0].own);
  CHECK(claims(fit) == "G1 G0 G2 ");
  CHECK(fit.report.outcome == Outcome::converged);
  const GivenCurves circle = given("<svg><circle r='3'/></svg>");
  CHECK(claims(circle.fit(circle.curves()[0].own)) == "G2 G2 G2 G2 ");
}

TEST_CASE("given curves: nodes are where the curve passes nearest, whichever way it runs", "[given]") {
  const Input corner = points({{1, 0}, {2, 1}});
  CHECK(places(path("M0 0L2 0L2 -2").fit(corner)) == "0:0+0.5 1:1+0.5 ");
  const Fit backwards = path("M2 -2L2 0L0 0").fit(corner);
  CHECK(backwards.report.outcome == Outcome::converged);
  CHECK(places(backwards) == "0:1+0.5 1:0+0.5 ");
  // Closed, from another start, backwards.
  const Input square = points({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, true);
  CHECK(places(path("M2 -2L2 0L0 0L0 -2z").fit(square)) == "0:2+0 1:1+0 2:0+0 3:3+0 ");
  CHECK(path("M2 -2L2 0L0 0L0 -2z").fit(square).report.outcome == Outcome::converged);
}

TEST_CASE("given curves: a curve that misses its points is said so, with the distance", "[given]") {
  const Fit fit = path("M0 0L4 0").fit(points({{0, 0}, {2, 0.5}, {4, 0}}));
  CHECK(fit.report.outcome == Outcome::not_converged);
  CHECK_THAT(fit.report.message, ContainsSubstring("the curve passes point 1 at"));
  const double chord = std::hypot(2.0, 0.5);
  CHECK(fit.report.residual == Approx(0.5 / chord).epsilon(1e-12));

  const Fit closed = path("M0 0L2 0L2 -2").fit(points({{0, 0}, {2, 0}, {2, 2}}, true));
  CHECK(closed.report.outcome == Outcome::not_converged);
  CHECK_THAT(closed.report.message, ContainsSubstring("the curve is open, the input closed"));
}

TEST_CASE("given curves: of several the points belong to the nearest, their own above all", "[given]") {
  const GivenCurves two = path("M0 0L10 0M0 -5L10 -5");
  CHECK(two.fit(points({{1, 5}, {9, 5}})).curve->start() == Vec2(0, 5));
  CHECK(two.fit(points({{1, 0}, {9, 1}})).curve->start() == Vec2(0, 0));
  // The square has its corners on the circle.
  const GivenCurves both = given("<svg><circle r='5'/><path d='M5 0L0 5L-5 0L0 -5z'/></svg>");
  const auto& square = both.curves().at(1);
  CHECK(std::holds_alternative<PolynomialForm>(both.fit(square.own).curve->segment(0).exact()));
}

TEST_CASE("given curves: curve JSON keeps its nodes, claims and report where they hold", "[given]") {
  const std::string json =
      R"({"format":"kappabench-curve","version":2,"closed":false,"iterations":7,"residual":1e-13,"segments":[)"
      R"({"type":"polynomial","control_points":[[0,0],[2,0]]},{"type":"polynomial","control_points":[[2,0],[2,2]]}],)"
      R"("nodes":[{"point":0,"segment":0,"t":0.25,"marks":["pinned"]},{"point":1,"segment":1,"t":0.5,"marks":[]}],)"
      R"("joints":[{"segment":0,"claimed":"G0"}]})";
  const GivenCurves curve = given(json, "mine.json");
  CHECK(curve.curves().at(0).own.points == std::vector<Vec2>{{0.5, 0}, {2, 1}});
  const Fit fit = curve.fit(points({{0.5, 0}, {2, 1}}));
  CHECK(fit.report.outcome == Outcome::converged);
  CHECK(fit.curve->nodes()[0].has("pinned"));
  CHECK(fit.report.iterations == 7);
  CHECK(fit.report.residual == 1e-13);
  // Other points: nodes by projection, and the residual is what it misses them by.
  const Fit other = curve.fit(points({{1, 0}, {2, 1}}));
  CHECK(other.report.outcome == Outcome::converged);
  CHECK(places(other) == "0:0+0.5 1:1+0.5 ");
  CHECK(other.report.residual == 0.0);
  // A claim that does not hold is refuted, not mended.
  std::string lie = json;
  lie.replace(lie.find("\"G0\""), 4, "\"G1\"");
  CHECK_THAT(given(lie, "lie.json").fit(points({{1, 0}, {2, 1}})).report.message,
             ContainsSubstring("the joint of segments 0 and 1 claims G1"));
}

TEST_CASE("given curves: nothing is fitted again", "[given]") {
  const GivenCurves curve = path("M0 0L2 0L2 -2");
  const Fit again = curve.refit(curve.fit(curve.curves()[0].own), Move{1, {3, 0}});
  CHECK(again.report.outcome == Outcome::failed);
  CHECK_FALSE(again.curve.has_value());
}

TEST_CASE("given curves: what a file holds is told by its start, and its digest by all of it", "[given]") {
  const ScratchFolder folder;
  const auto read = [&](const std::string& content) { return read_curve_file(file_in(folder, "f", content)); };
  CHECK(read(" \n<svg><path d='M0 0H1'/></svg>").curves.size() == 1);
  CHECK(read("[{\"segments\":[{\"type\":\"polynomial\",\"control_points\":[[0,0],[1,0]]}]}]").curves.size() == 1);
  CHECK_THAT(refusal([&] { return read("0 0\n1 1\n"); }), ContainsSubstring("f:1: neither curve JSON nor SVG"));
  CHECK_THROWS_AS(read("{\"segments\":3}"), std::invalid_argument);
  const std::string one = "<svg><path d='M0 0H1'/></svg>", other = "<svg><path d='M0 0H2'/></svg>";
  CHECK(read(one).digest == read(one).digest);
  CHECK(read(one).digest != read(other).digest);
  CHECK(GivenCurves("f", read(one)).info().plugin_digest == read(one).digest);
  CHECK_THROWS_WITH(given(R"({"segments":[{"type":"polynomial","control_points":[[0,0],[1,0]]}],)"
                          R"("nodes":[{"point":0,"segment":0,"t":0.5,"marks":["two words"]}]})"),
                    ContainsSubstring("mine.svg: curve 0: "));
  // A file of a fit that failed has no curve.
  const GivenCurves none("f", read("{\"outcome\":\"failed\",\"segments\":[]}"));
  CHECK(none.curves().empty());
  CHECK(none.fit(points({{0, 0}, {1, 0}})).report.outcome == Outcome::failed);
}
