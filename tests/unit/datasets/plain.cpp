#include <cmath>
#include <numbers>

#include "datasets/readers.hpp"
#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;

namespace {

Drawing plain(std::string_view text) { return parse_plain(text, "f.txt"); }
std::string refused(std::string_view text) {
  return refusal([&] { return plain(text); });
}

}  // namespace

TEST_CASE("plain text: curves, options and metadata", "[datasets]") {
  const Drawing drawing = plain(
      "# title: Two curves\n# stands-in-for: -\n#source:by hand\n# licence: CC0\n# units: mm\n# just a remark\n"
      "closed\n0 0\n1 0 type=cusp a=0.85\n# between\n+1\t1e0 tangent=90 # to the top\n"
      "\n  \n"
      "-2 -.5 h=0.5 alpha=0.3 beta=.25 curvature=-2\n3 4\n");
  CHECK(drawing.title == "Two curves");
  CHECK(drawing.stands_in_for.empty());
  CHECK(drawing.source == "by hand");
  CHECK(drawing.licence == "CC0");
  CHECK(drawing.units == "mm");
  REQUIRE(drawing.curves.size() == 2);

  const Input& first = drawing.curves[0];
  CHECK(first.closed);
  REQUIRE(first.size() == 3);
  CHECK(first.points[2] == Vec2(1.0, 1.0));
  REQUIRE(first.options.size() == 3);
  CHECK(first.options[0] == PointOptions{});
  CHECK(first.options[1].type == PointType::cusp);
  CHECK(first.options[1].a == 0.85);
  CHECK(*first.options[2].tangent == Approx(std::numbers::pi / 2).epsilon(1e-15));

  const Input& second = drawing.curves[1];
  CHECK_FALSE(second.closed);
  CHECK(second.points[0] == Vec2(-2.0, -0.5));
  CHECK(second.options[0].h == 0.5);
  CHECK(second.options[0].alpha == 0.3);
  CHECK(second.options[0].beta == 0.25);
  CHECK(second.options[0].curvature == -2.0);
}

TEST_CASE("plain text: a curve is open unless it says closed, whatever came before", "[datasets]") {
  const Drawing drawing = plain("0 0\n1 1\n\nclosed\n0 0\n1 0\n0 1\n\n5 5\n");
  REQUIRE(drawing.curves.size() == 3);
  CHECK_FALSE(drawing.curves[0].closed);
  CHECK(drawing.curves[1].closed);
  CHECK_FALSE(drawing.curves[2].closed);
  CHECK(drawing.curves[0].options.empty());
}

TEST_CASE("plain text: few and coincident points are for the schemes to refuse", "[datasets]") {
  CHECK(plain("1 2").curves[0].size() == 1);
  CHECK(plain("closed\n0 0\n1 0\n1 0\n0 0\n").curves[0].size() == 4);
}

TEST_CASE("plain text: Windows line ends and a byte order mark", "[datasets]") {
  const ScratchFolder scratch;
  const Drawing drawing =
      read_drawing(file_in(scratch, "dos.txt", "\xEF\xBB\xBF# title: DOS\r\nclosed\r\n0 0\r\n1 0\r\n\r\n2 2\r\n"));
  CHECK(drawing.id == "dos");
  CHECK(drawing.title == "DOS");
  REQUIRE(drawing.curves.size() == 2);
  CHECK(drawing.curves[0].size() == 2);
}

TEST_CASE("plain text: each refusal names file, line and remedy", "[datasets]") {
  using Catch::Matchers::StartsWith;
  CHECK_THAT(refused("0 0\n1\n"), StartsWith("f.txt:2: y is missing; "));
  CHECK_THAT(refused("0 0\n\n1 nan\n"), StartsWith("f.txt:3: y = \"nan\" is not finite; "));
  CHECK_THAT(refused("inf 0\n"), StartsWith("f.txt:1: x = \"inf\" is not finite; "));
  CHECK_THAT(refused("-inf 0\n"), StartsWith("f.txt:1: x = \"-inf\" is not finite; "));
  CHECK_THAT(refused("1e999 0\n"), StartsWith("f.txt:1: x = \"1e999\" does not fit a double; "));
  CHECK_THAT(refused("0 0\n1,5 2\n"), StartsWith("f.txt:2: x = \"1,5\" is not a number; "));
  CHECK_THAT(refused("0 0x10\n"), StartsWith("f.txt:1: y = \"0x10\" is not a number; "));
  CHECK_THAT(refused("0 +-1\n"), StartsWith("f.txt:1: y = \"+-1\" is not a number; "));
  CHECK_THAT(refused("0 0 7\n"), StartsWith("f.txt:1: \"7\" after the coordinates; "));
  CHECK_THAT(refused("0 0 b=7\n"), StartsWith("f.txt:1: unknown key \"b\"; known are type, a, h"));
  CHECK_THAT(refused("0 0 a=1 a=1\n"), StartsWith("f.txt:1: a is given twice; "));
  CHECK_THAT(refused("0 0 type=cusp type=loop\n"), StartsWith("f.txt:1: type is given twice; "));
  CHECK_THAT(refused("0 0 type=kink\n"), StartsWith("f.txt:1: type = \"kink\" is unknown; give regular, cusp"));
  CHECK_THAT(refused("0 0 a=\n"), StartsWith("f.txt:1: a = \"\" is not a number; "));
  CHECK_THAT(refused("0 0\nclosed\n"), StartsWith("f.txt:2: \"closed\" inside a curve; "));
  CHECK_THAT(refused("open\nclosed\n0 0\n"), StartsWith("f.txt:2: \"closed\" inside a curve; "));
  CHECK_THAT(refused("closed\n\n0 0\n"), StartsWith("f.txt:2: a curve without points; "));
  CHECK_THAT(refused("0 0\n\nclosed\n"), StartsWith("f.txt:3: a curve without points; "));
  CHECK_THAT(refused("# title: a\n# title: b\n0 0\n"), StartsWith("f.txt:2: title is given twice; "));
  CHECK_THAT(refused("# nothing\n"), StartsWith("f.txt: no points; "));
}

TEST_CASE("a file that is no readable text is refused by name", "[datasets]") {
  using Catch::Matchers::Contains;
  using Catch::Matchers::StartsWith;
  const ScratchFolder scratch;
  const auto refused_file = [](const std::filesystem::path& file) {
    return refusal([&] { return read_drawing(file); });
  };
  const auto nul = file_in(scratch, "nul.txt", std::string_view("0 0\n1 \0 2\n", 10));
  CHECK_THAT(refused_file(nul), StartsWith(nul.string() + ":2: a NUL byte; "));
  const auto latin = file_in(scratch, "latin.txt", "0 0\n1 1\n# caf\xE9\n");
  CHECK_THAT(refused_file(latin), StartsWith(latin.string() + ":3: not UTF-8; "));
  for (const std::string_view broken : {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xFF"}) {
    CHECK_THAT(refused_file(file_in(scratch, "broken.txt", broken)), Contains(":1: not UTF-8; "));
  }
  const auto empty = file_in(scratch, "empty.txt", "");
  CHECK_THAT(refused_file(empty), StartsWith(empty.string() + ": empty; "));
  CHECK_THAT(refused_file(file_in(scratch, "blank.toml", " \n\n")), Contains(": empty; "));
  CHECK_THAT(refused_file(scratch.path()), StartsWith(scratch.path().string() + ": a folder; "));
  const auto missing = scratch.path() / "missing.txt";
  CHECK_THAT(refused_file(missing), StartsWith(missing.string() + ": cannot be opened ("));
}

TEST_CASE("messages show what was read without control characters and in bounds", "[datasets]") {
  const std::string message = refused("0 \x1b[31m" + std::string(1000, 'z') + "\n");
  CHECK(message.find('\x1b') == std::string::npos);
  CHECK(message.find('\n') == std::string::npos);
  CHECK(message.size() < 200);
}
