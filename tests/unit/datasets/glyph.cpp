#include "datasets/glyph.hpp"

#include <algorithm>

#include "datasets/font_files.hpp"
#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;
using Catch::Matchers::Contains;

namespace {

/// Some font of this machine; empty if it has none, and then the tests are skipped.
std::string some_font() {
  for (const std::string_view font : {"DejaVu Sans", "Liberation Sans", "Noto Sans", "Arial"}) {
    std::string file;
    if (refusal([&] { return file = find_font(font, {"test", 0}).string(); }).empty()) return file;
  }
  WARN("skipped: no font found");
  return "";
}

std::string refused(const std::string& name) {
  return refusal([&] { return open_drawings(name); });
}

double signed_area(const Input& contour) {
  double area = 0.0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    area += cross(contour.points[i], contour.points[(i + 1) % contour.points.size()]) / 2.0;
  }
  return area;
}

}  // namespace

TEST_CASE("a glyph is closed contours without coincident points", "[datasets]") {
  const std::string font = some_font();
  if (font.empty()) return;
  for (const std::string character : {"o", "g", "B", "8", "&", "\xC3\xA9", "U+0040", ":"}) {
    const Drawing drawing = open_drawings("glyph:" + font + ":" + character).at(0);
    CAPTURE(character, drawing.title);
    CHECK_THAT(drawing.units, Contains("font units"));
    REQUIRE(!drawing.curves.empty());
    for (const Input& contour : drawing.curves) {
      CHECK(contour.closed);
      REQUIRE(contour.size() >= 3);
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        CHECK((contour.points[(i + 1) % contour.points.size()] - contour.points[i]).norm() >= 0.5);
      }
    }
  }
}

TEST_CASE("an o is two contours, the inner one turning the other way, with points at all extrema", "[datasets]") {
  const std::string font = some_font();
  if (font.empty()) return;
  const Drawing drawing = glyph_drawing("glyph:" + font + ":o");
  REQUIRE(drawing.curves.size() == 2);
  CHECK(signed_area(drawing.curves[0]) * signed_area(drawing.curves[1]) < 0.0);
  for (const Input& contour : drawing.curves) {
    // A round contour has its four extrema at points whose neighbours lie on either side along the other axis.
    const auto left = std::ranges::min_element(contour.points, {}, [](const Vec2& p) { return p.x(); });
    const auto top = std::ranges::max_element(contour.points, {}, [](const Vec2& p) { return p.y(); });
    const auto [low, high] = std::ranges::minmax(contour.points, {}, [](const Vec2& p) { return p.y(); });
    CHECK(std::abs(left->y() - (low.y() + high.y()) / 2.0) < 0.05 * (high.y() - low.y()));
    CHECK(top->y() > left->y());
  }
}

TEST_CASE("glyphs that are not there", "[datasets]") {
  CHECK_THAT(refused("glyph:No Such Font 17:a"), Contains("no font \"No Such Font 17\"; name a font file"));
  CHECK_THAT(refused("glyph:a"), Contains("write glyph:FONT:CHAR"));
  CHECK_THAT(refused("glyph::a"), Contains("write glyph:FONT:CHAR"));
  CHECK_THAT(refused("glyph:Font:"), Contains("write glyph:FONT:CHAR"));
  CHECK_THAT(refused("glyph:Font:ab"), Contains("\"ab\" is no single character; "));
  CHECK_THAT(refused("glyph:Font:U+XYZ"), Contains("\"U+XYZ\" is no character; "));
  CHECK_THAT(refused("glyph:Font:U+110000"), Contains("\"U+110000\" is no character; "));
  const ScratchFolder scratch;
  const std::string text = file_in(scratch, "font.ttf", "this is no font").string();
  CHECK_THAT(refused("glyph:" + text + ":a"), Contains("is no font that FreeType reads; "));

  const std::string font = some_font();
  if (font.empty()) return;
  CHECK_THAT(refused("glyph:" + font + ": "), Contains("U+0020"));
  CHECK_THAT(refused("glyph:" + font + ": "), Contains("is empty; "));
  CHECK_THAT(refused("glyph:" + font + ":U+10FFFF"), Contains("has no U+10FFFF; "));
}
