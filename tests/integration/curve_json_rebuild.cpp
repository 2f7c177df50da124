// The JSON of a fit holds everything that is needed to draw its curve: segments built from it alone are the same.
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
  for (const std::string_view text :
       {"cubic-spline", "hobby", "ekappa-trig", "clothoid3", "clothoid3:pieces=clc", "yuksel", "yuksel:arc=bezier",
        "yuksel:arc=elliptical", "yuksel:parametrization=c2", "yuksel:arc=bezier,parametrization=c2"}) {
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
