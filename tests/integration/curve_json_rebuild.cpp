// The JSON of a fit holds everything that is needed to draw its curve: segments built from it alone are the same.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "datasets/datasets.hpp"
#include "schemes/api/curve_json.hpp"
#include "schemes/segments/blend.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/reparametrized.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

using Json = nlohmann::json;

Vec2 point(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

std::vector<Vec2> points(const Json& json) {
  std::vector<Vec2> result;
  for (const Json& p : json) result.push_back(point(p));
  return result;
}

/// `types` collects what was met.
SegmentPtr segment(const Json& json, std::set<std::string>& types) {
  const auto type = json.at("type").get<std::string>();
  types.insert(type);
  if (type == "polynomial") return std::make_shared<PolynomialSegment>(points(json.at("control_points")));
  if (type == "trigonometric") {
    const std::vector<Vec2> p = points(json.at("control_points"));
    return std::make_shared<TrigonometricSegment>(std::array{p.at(0), p.at(1), p.at(2), p.at(3), p.at(4)});
  }
  if (type == "clothoid")
    return std::make_shared<ClothoidSegment>(ClothoidForm{
        point(json.at("start")), json.at("angle"), json.at("curvature"), json.at("curvature_rate"), json.at("length")});
  if (type == "elliptic_arc")
    return std::make_shared<EllipticArcSegment>(EllipticArcForm{
        point(json.at("centre")), point(json.at("axis_a")), point(json.at("axis_b")), json.at("from"), json.at("to")});
  if (type == "reparametrized")
    return std::make_shared<ReparametrizedSegment>(segment(json.at("of"), types), json.at("start_speed"));
  if (type == "blend")
    return std::make_shared<BlendSegment>(segment(json.at("from"), types), segment(json.at("to"), types));
  throw std::runtime_error("unknown type of segment " + type);
}

}  // namespace

TEST_CASE("segments rebuilt from the JSON of a fit are the fit's") {
  std::set<std::string> types;
  for (const std::string_view text : {"cubic-spline", "hobby", "euler-spiral", "ekappa-trig", "clothoid3",
                                      "clothoid3:pieces=clc", "yuksel", "yuksel:arc=bezier", "yuksel:arc=elliptical",
                                      "yuksel:parametrization=c2", "yuksel:arc=bezier,parametrization=c2"}) {
    const SchemePtr tested = scheme(text);
    for (const Drawing& drawing : open_drawings("bird"))
      for (const Input& input : drawing.curves) {
        INFO(text);
        const Fit fit = tested->fit(input);
        REQUIRE(fit.curve.has_value());
        const Json json = Json::parse(curve_json(*tested, fit));
        REQUIRE(static_cast<int>(json.at("segments").size()) == fit.curve->size());
        for (int k = 0; k < fit.curve->size(); ++k) {
          const SegmentPtr again = segment(json.at("segments").at(static_cast<std::size_t>(k)), types);
          for (const double t : {0.0, 0.3, 0.9, 1.0})
            CHECK(again->jet(t, 1).d[1] == fit.curve->segment(k).jet(t, 1).d[1]);
        }
      }
  }
  CHECK(types ==
        std::set<std::string>{"blend", "clothoid", "elliptic_arc", "polynomial", "reparametrized", "trigonometric"});
}

TEST_CASE("numbers of the JSON read back bit for bit, and what is no number or no UTF-8 is still JSON") {
  const SchemePtr tested = scheme("catmull-rom");
  const double third = 1.0 / 3.0, tiny = 5e-324, next = std::nextafter(1.0, 2.0);
  const std::vector<Vec2> controls{{third, tiny}, {next, -0.0}, {1e300, 123456789012345678.0}};
  const Curve curve({std::make_shared<PolynomialSegment>(controls)}, {},
                    {{.point = 0, .segment = 0, .t = third, .marks = {"second", "first", "second"}}}, false);
  Fit fit{.input = {.points = {{0, 0}, {1, 0}, {2, 0}}, .closed = false}, .curve = curve};
  fit.report.message = "\xff \"quoted\" \\";
  fit.report.residual = std::numeric_limits<double>::quiet_NaN();
  fit.report.counters["steps"] = 7;
  const Json json = Json::parse(curve_json(*tested, fit));
  const std::vector<Vec2> again = points(json["segments"][0]["control_points"]);
  for (std::size_t i = 0; i < controls.size(); ++i)
    for (int k = 0; k < 2; ++k)
      CHECK(std::bit_cast<std::uint64_t>(again[i][k]) == std::bit_cast<std::uint64_t>(controls[i][k]));
  CHECK(json["residual"].is_null());
  CHECK(json["message"] == "\uFFFD \"quoted\" \\");
  CHECK(json["iterations"].is_number_integer());
  CHECK(json["counters"]["steps"].is_number_integer());
  const Json node = json["nodes"][0];
  CHECK(node.size() == 4);
  CHECK(node["t"] == third);
  CHECK(node["marks"] == Json::array({"first", "second"}));
}
