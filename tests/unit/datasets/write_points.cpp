#include "datasets/write_points.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <sstream>

#include "datasets/fields.hpp"
#include "datasets/random_points.hpp"
#include "datasets/random_source.hpp"
#include "datasets/readers.hpp"
#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;

namespace {

std::string written(const Drawing& drawing) {
  std::ostringstream out;
  write_points(out, drawing);
  return out.str();
}

void check_same(const Drawing& a, const Drawing& b) {
  CHECK(a.title == b.title);
  CHECK(a.stands_in_for == b.stands_in_for);
  CHECK(a.source == b.source);
  CHECK(a.licence == b.licence);
  CHECK(a.units == b.units);
  REQUIRE(a.curves.size() == b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    CHECK(a.curves[i].closed == b.curves[i].closed);
    CHECK(a.curves[i].points == b.curves[i].points);
    CHECK(a.curves[i].options == b.curves[i].options);
  }
}

}  // namespace

TEST_CASE("what is written is read back bit for bit", "[datasets]") {
  const PointOptions everything{.type = PointType::loop,
                                .a = 2.0 / 3.0,
                                .h = -0.1,
                                .alpha = 0.3,
                                .beta = 1e-17,
                                .tangent = {},
                                .curvature = -1e300};
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  const Drawing drawing{.id = "d",
                        .title = "a title",
                        .stands_in_for = "Somebody 1999, Fig. 1",
                        .source = "here: and there",
                        .licence = "CC0",
                        .units = "mm",
                        .curves = {{.points = {{0.1, 1.0 / 3.0}, {most, -1e-300}, {1e23, 5e-324 + least}},
                                    .closed = true,
                                    .options = {{}, everything, {}},
                                    .ids = {}},
                                   {.points = {{-0.0, 7.0}}, .closed = false, .options = {}, .ids = {}}}};
  check_same(parse_plain(written(drawing), "f"), drawing);
}

TEST_CASE("every number of a point is named once, written and read", "[datasets]") {
  for (const PointNumber& number : point_numbers) {
    CAPTURE(number.name);
    CHECK(std::ranges::count(point_numbers, number.name, &PointNumber::name) == 1);
    CHECK(std::ranges::count(point_numbers, number.member, &PointNumber::member) == 1);
    PointOptions one;
    one.*number.member = 0.5 * number.file_unit;
    const Drawing drawing{.id = "d", .curves = {{.points = {{0, 0}, {1, 0}}, .options = {one, {}}}}};
    CHECK(written(drawing).find(std::string(number.name) + "=0.5") != std::string::npos);
    check_same(parse_plain(written(drawing), "f"), drawing);
    CHECK(point_keys_text().find(number.name) != std::string::npos);
  }
}

TEST_CASE("a tangent that came from a file goes back to the same file", "[datasets]") {
  RandomSource random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string text = "open\n0 0 tangent=" + std::to_string(random.uniform(-360.0, 360.0)) + "\n";
    const Drawing once = parse_plain(text, "f");
    check_same(parse_plain(written(once), "f"), once);
  }
}

TEST_CASE("the built-in drawings and random points survive writing", "[datasets]") {
  for (const Drawing& drawing : builtin_drawings()) {
    CAPTURE(drawing.id);
    check_same(parse_plain(written(drawing), "f"), drawing);
  }
  for (const RandomKind kind : random_kinds()) {
    const Drawing drawing{.id = "r", .curves = {random_input(kind, 40, 5, false), random_input(kind, 40, 6, true)}};
    check_same(parse_plain(written(drawing), "f"), drawing);
  }
}

TEST_CASE("what plain text cannot say is not written", "[datasets]") {
  CHECK_THROWS_AS(written({.id = "d", .curves = {Input{}}}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(written({.id = "d", .curves = {{.points = {{0.0, nan}}, .closed = false, .options = {}, .ids = {}}}}),
                  std::invalid_argument);
}

TEST_CASE("a line break in a title does not break the file", "[datasets]") {
  const Drawing drawing{.id = "d",
                        .title = "two\nlines",
                        .curves = {{.points = {{1.0, 2.0}}, .closed = false, .options = {}, .ids = {}}}};
  CHECK(parse_plain(written(drawing), "f").title == "two lines");
}
