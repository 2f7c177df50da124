#include <cmath>
#include <limits>

#include "schemes/api/known_words.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const std::vector<ParameterSpec> specs{
    {.name = "a", .default_value = 0.8, .help = "", .least = 0.5, .most = 1.0, .most_included = false},
    {.name = "iteration", .default_value = std::string("newton"), .help = "", .choices = {"newton", "published"}},
    {.name = "steps", .default_value = 50L, .help = "", .least = 1},
    {.name = "refine", .default_value = true, .help = ""}};

std::string complaint(std::string_view text) {
  try {
    (void)Parameters::parse(specs, text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

Input square() { return {.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .closed = true}; }

}  // namespace

TEST_CASE("parameters are parsed against their specification") {
  const Parameters p = Parameters::parse(specs, "a=0.75,refine=false,steps=7,iteration=published");
  CHECK(p.real("a") == 0.75);
  CHECK(p.integer("steps") == 7);
  CHECK_FALSE(p.flag("refine"));
  CHECK(p.text("iteration") == "published");
  CHECK(p.canonical() == "a=0.75,iteration=published,refine=false,steps=7");
  CHECK(Parameters::parse(specs, "").brief().empty());
  CHECK(Parameters::parse(specs, "a=0.9").brief() == "a=0.9");
}

TEST_CASE("a wrong parameter is named with what would be right") {
  CHECK(complaint("a=1") == "a=1: allowed is a number in [0.5, 1)");
  CHECK(complaint("a=nan") == "a=nan: allowed is a number in [0.5, 1)");
  CHECK(complaint("a=0.8x") == "a=0.8x: not a number; allowed is a number in [0.5, 1)");
  CHECK(complaint("b=1") == "unknown parameter 'b'; known are a, iteration, steps, refine");
  CHECK(complaint("iteration=magic") == "iteration=magic: allowed is newton|published");
  CHECK(complaint("refine=yes") == "refine=yes: allowed is true|false");
  CHECK(complaint("steps=1.5") == "steps=1.5: not a number; allowed is an integer in [1, inf)");
  CHECK(complaint("a=0.6,a=0.7") == "parameter 'a' is given twice");
  CHECK(complaint("a").starts_with("'a': a parameter is written key=value"));
}

TEST_CASE("the registry knows its schemes and refuses others by name") {
  const Registry& registry = all_schemes();
  CHECK(registry.parse("cubic-spline:parameter=uniform")->parameters().text("parameter") == "uniform");
  CHECK_THROWS_WITH(registry.parse("spline"),
                    ContainsSubstring("unknown scheme 'spline'; did you mean cubic-spline? known are"));
  CHECK_THROWS_WITH(registry.parse("cubic-spline:knots=3"),
                    ContainsSubstring("scheme 'cubic-spline': unknown parameter"));
}

TEST_CASE("every scheme refuses what no scheme can take, in one line") {
  const Registry& registry = all_schemes();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto refused = [](const Scheme& scheme, const Input& input, std::string_view why) {
    const Fit fit = scheme.fit(input);
    CHECK(fit.report.outcome == Outcome::unsupported_input);
    CHECK_FALSE(fit.curve.has_value());
    CHECK_THAT(fit.report.message, ContainsSubstring(std::string(why)));
    CHECK(fit.report.message.find('\n') == std::string::npos);
  };
  for (const SchemeInfo& info : registry.list()) {
    INFO(info.id);
    const SchemePtr scheme = registry.create(info.id);
    refused(*scheme, {.points = {}, .closed = true}, "0 points");
    refused(*scheme, {.points = {{0, 0}}, .closed = false}, "1 point;");
    refused(*scheme, {.points = {{0, 0}, {1, 0}}, .closed = true}, "2 points; a closed curve needs at least 3");
    refused(*scheme, {.points = {{0, 0}, {1, nan}, {2, 0}}, .closed = false}, "point 1 is not finite");
    refused(*scheme, {.points = {{0, 0}, {1, 0}, {inf, 0}}, .closed = false}, "point 2 is not finite");
    refused(*scheme, {.points = {{0, 0}, {1, 0}, {1, 0}, {2, 1}}, .closed = false}, "points 1 and 2 coincide");
    refused(*scheme, {.points = {{0, 0}, {1, 0}, {1, 1}, {0, 0}}, .closed = true}, "must not repeat its first point");
    refused(*scheme, {.points = {{0, 0}, {1e200, 0}, {0, 1}}, .closed = false}, "too far apart");
  }
}

TEST_CASE("edits keep the ids of the other points") {
  const Input inserted = apply(square(), Insert{.before = 1, .at = {0.5, -0.1}});
  CHECK(inserted.ids == std::vector<int>{0, 4, 1, 2, 3});
  const Input erased = apply(inserted, Erase{.point = 2});
  CHECK(erased.ids == std::vector<int>{0, 4, 2, 3});
  const Input again = apply(erased, Insert{.before = 4, .at = {0.1, 0.5}, .options = {.a = 0.9}});
  CHECK(again.ids == std::vector<int>{0, 4, 2, 3, 1});
  CHECK(again.options_of(4).a == 0.9);
  CHECK_FALSE(again.options_of(0).a.has_value());
  CHECK(apply(square(), Move{.point = 2, .to = {3, 3}}).points[2] == Vec2(3, 3));
  CHECK_THROWS_AS(apply(square(), Erase{.point = 4}), std::out_of_range);
}

TEST_CASE("the mean chord counts the closing chord of closed input only") {
  Input input = square();
  CHECK(mean_chord(input) == 1.0);
  input.points.pop_back();
  CHECK(mean_chord(input) == Approx((2.0 + std::sqrt(2.0)) / 3.0));
  input.closed = false;
  CHECK(mean_chord(input) == 1.0);
}

TEST_CASE("an unknown word is answered with what may have been meant, nearest first") {
  const std::vector<std::string> known{"kappa", "ekappa", "pkappa", "fpc", "a", "cubic-spline"};
  CHECK(known_words("kapa", known) ==
        "did you mean kappa or ekappa or pkappa? known are kappa, ekappa, pkappa, fpc, a, cubic-spline");
  CHECK(nearest_words("spline", known) == std::vector<std::string>{"cubic-spline"});
  CHECK(nearest_words("fcp", known).empty());
  CHECK(nearest_words("b", known).empty());
  CHECK(nearest_words("", known).empty());
  CHECK(nearest_words(std::string(100000, 'k'), known).empty());
}
