#include "schemes/api/read_curve_json.hpp"

#include <fmt/format.h>

#include <string>

#include "datasets/datasets.hpp"
#include "schemes/api/curve_json.hpp"
#include "schemes/segments/rational.hpp"
#include "schemes/segments/sampled.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

/// A record with one segment given as JSON.
std::string with_segment(const std::string& segment) { return R"({"segments":[)" + segment + "]}"; }

/// Reading says `what`, and where: the source first.
void refused(const std::string& json, const std::string& what) {
  INFO(json.substr(0, 200));
  try {
    static_cast<void>(read_curves(json, "mine.json"));
    FAIL_CHECK("it was read");
  } catch (const std::invalid_argument& error) {
    CHECK_THAT(error.what(), ContainsSubstring(what));
    CHECK(std::string(error.what()).starts_with("mine.json: "));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    CHECK(std::string(error.what()).size() < 400);
  }
}

std::string nested(int depth) {
  std::string text = R"({"type":"polynomial","control_points":[[0,0],[1,0]]})";
  for (int i = 0; i < depth; ++i) text = R"({"type":"reparametrized","start_speed":2,"of":)" + text + "}";
  return text;
}

/// The curves of a built-in drawing.
std::vector<Input> curves_of(const char* drawing) { return open_drawings(drawing).front().curves; }

}  // namespace

TEST_CASE("what is written is read back, bit for bit: every scheme, every drawing of a few points") {
  for (const SchemeInfo& info : all_schemes().list()) {
    const SchemePtr tested = scheme(info.id);
    for (const char* drawing : {"toy", "figure-eight", "hairpin"})
      for (const Input& input : curves_of(drawing)) {
        INFO(info.id << " on " << drawing);
        const std::vector<Fit> fits{tested->fit(input)};
        if (!fits.front().curve) continue;
        const std::string json = curves_json(*tested, fits);
        const std::vector<CurveRecord> records = read_curves(json, "fit");
        REQUIRE(records.size() == 1);
        const CurveRecord& record = records.front();
        CHECK(record.scheme == info.id);
        CHECK(record.closed == input.closed);
        CHECK(record.report.outcome == fits.front().report.outcome);
        CHECK(record.report.counters == fits.front().report.counters);
        const Curve curve = curve_of(record, {});
        // Written again it is the same text, but for what a record does not keep.
        Fit again = fits.front();
        again.curve = curve;
        CHECK(curves_json(*tested, std::vector<Fit>{again}) == json);
        for (int k = 0; k < curve.size(); ++k)
          for (const double t : {0.0, 0.37, 1.0})
            CHECK(curve.segment(k).jet(t, 2).d[2] == fits.front().curve->segment(k).jet(t, 2).d[2]);
      }
  }
}

TEST_CASE("rational, sampled and formless segments are written and read") {
  class Formless final : public Segment {
   public:
    [[nodiscard]] Jet jet(double t, int order) const override { return circle_.jet(t, order); }
    [[nodiscard]] ExactForm exact() const override { return OpaqueForm{}; }

   private:
    RationalSegment circle_{{{{1, 0}, {1, 1}, {0, 1}}, {1.0, 0.75, 1.0}}};
  };
  const auto formless = std::make_shared<Formless>();
  const auto rational = std::make_shared<RationalSegment>(RationalForm{{{0, 1}, {-1, 1}, {-1, 0}}, {1.0, 0.75, 1.0}});
  const SchemePtr any = scheme("catmull-rom");
  const Fit fit{.input = {.points = {{1, 0}, {0, 1}, {-1, 0}}},
                .curve = Curve({formless, rational}, {{0, Continuity::g1}}, {}, false)};
  const Curve read = curve_of(read_curves(curve_json(*any, fit), "fit").front(), {});
  CHECK(std::holds_alternative<SampledForm>(read.segment(0).exact()));
  CHECK(std::holds_alternative<RationalForm>(read.segment(1).exact()));
  for (const double t : {0.0, 0.123, 0.5, 1.0}) {
    CHECK((read.segment(0).jet(t, 1).d[1] - formless->jet(t, 1).d[1]).norm() <= 1e-10);
    CHECK(read.segment(1).jet(t, 3).d[3] == rational->jet(t, 3).d[3]);
  }
}

TEST_CASE("what a record leaves out is taken from what is known") {
  const std::string line = R"([{"segments":[{"type":"polynomial","control_points":[[0,0],[1,0]]},)"
                           R"({"type":"polynomial","control_points":[[1,0],[1,1]]}]}])";
  const CurveRecord record = read_curves(line, "line").front();
  CHECK(record.report.outcome == Outcome::converged);
  CHECK_FALSE(record.closed.has_value());
  const std::vector<Vec2> points{{0, 0}, {0.5, 0}, {1, 1}};
  const Curve curve = curve_of(record, {.closed = false, .points = points, .claimed = Continuity::g0});
  CHECK(curve.joints().size() == 1);
  REQUIRE(curve.nodes().size() == 3);
  CHECK(curve.nodes()[1].segment == 0);
  CHECK(curve.nodes()[1].t == Approx(0.5).margin(1e-15));
  CHECK(curve.nodes()[2].t == 1.0);
  CHECK(curve_of(record, {.closed = true}).joints().size() == 2);
  CHECK_FALSE(read_curves(R"({"outcome":"failed","message":"no"})", "one").front().segments.size() > 0);
}

TEST_CASE("hostile curve JSON is refused in one line that says where") {
  refused("", "not JSON");
  refused("{", "not JSON");
  refused("nonsense", "line 1");
  refused(R"({"segments":[1e999]})", "overflow");
  refused("[]", "no curve");
  refused("3", "no curve");
  refused("[3]", "curve 0: : 3; a curve is an object");
  refused(R"({"format":"svg","segments":[]})", "format: \"svg\"");
  refused(R"({"version":3,"segments":[]})", "version: 3; versions 1 and 2");
  refused("{}", "no \"segments\"");
  refused(R"({"segments":5})", "segments: 5; a list");
  refused(R"({"outcome":"fine","segments":[]})", "outcome: \"fine\"; known are");
  refused(with_segment("7"), "segments[0]: 7; a segment is an object");
  refused(with_segment("{}"), "segments[0]: no \"type\"");
  refused(with_segment(R"({"type":"spiral"})"), "segments[0].type: \"spiral\"; known are polynomial");
  refused(with_segment(R"({"type":"polynomial"})"), "no \"control_points\"");
  refused(with_segment(R"({"type":"polynomial","control_points":[[0,0]]})"), "segments[0]: ");
  refused(with_segment(R"({"type":"polynomial","control_points":[[0,0],[1]]})"), "control_points[1]: [1]; a point");
  refused(with_segment(R"({"type":"polynomial","control_points":[[0,0],[1,null]]})"), "control_points[1][1]: null");
  refused(with_segment(R"({"type":"polynomial","control_points":[[0,0],[1,"2"]]})"), "a number is needed");
  refused(with_segment(R"({"type":"rational","control_points":[[0,0],[1,0]],"weights":[1,-1]})"),
          "weights are positive");
  refused(with_segment(R"({"type":"rational","control_points":[[0,0],[1,0]],"weights":[1]})"), "one weight");
  refused(with_segment(R"({"type":"trigonometric","control_points":[[0,0]]})"), "5 control points");
  refused(with_segment(R"({"type":"clothoid","start":[0,0],"angle":0,"curvature":1,"curvature_rate":0,"length":0})"),
          "length: 0; a positive number");
  refused(with_segment(R"({"type":"intrinsic","start":[0,0],"angle":0,"length":1,"degree":2,"knots":[0,1],)"
                       R"("control_curvatures":[1,2]})"),
          "segments[0]: ");
  refused(with_segment(R"({"type":"intrinsic","start":[0,0],"angle":0,"length":1,"degree":99,"knots":[],)"
                       R"("control_curvatures":[]})"),
          "degree: 99");
  refused(
      with_segment(R"({"type":"sampled","t":[0,1],"x":[0,1],"y":[0],"dx":[1,1],"dy":[0,0],"ddx":[0,0],"ddy":[0,0]})"),
      "as many x as y");
  refused(with_segment(nested(30)), "deep at most");
  CHECK_NOTHROW(read_curves(with_segment(nested(3)), "nested"));

  const std::string line = R"("segments":[{"type":"polynomial","control_points":[[0,0],[1,0]]}])";
  refused("{" + line + R"(,"nodes":[{"point":0,"segment":1,"t":0}]})", "nodes[0].segment: 1");
  refused("{" + line + R"(,"nodes":[{"point":-1,"segment":0,"t":0}]})", "point: -1");
  refused("{" + line + R"(,"nodes":[{"point":0,"segment":0,"t":2}]})", "t: 2");
  refused("{" + line + R"(,"joints":[{"segment":0,"claimed":"G7"}]})", "claimed: \"G7\"");
  refused("{" + line + R"(,"counters":{"steps":1.5}})", "counters.steps: 1.5");
  // Very deep and very long texts neither crash nor flood the terminal.
  refused(std::string(100000, '['), "not JSON");
  refused(with_segment("\"" + std::string(100000, 'a') + "\""), "segments[0]: string");
}

TEST_CASE("joints that are too few for the segments are refused when the curve is made") {
  const CurveRecord record =
      read_curves(R"({"joints":[],"segments":[{"type":"polynomial","control_points":[[0,0],[1,0]]},)"
                  R"({"type":"polynomial","control_points":[[1,0],[1,1]]}]})",
                  "two")
          .front();
  CHECK_THROWS_AS(curve_of(record, {}), std::invalid_argument);
}
