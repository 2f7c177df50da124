#include <cmath>
#include <numbers>

#include "datasets/readers.hpp"
#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;
using Catch::Matchers::StartsWith;

namespace {

using Parser = Drawing (*)(std::string_view, std::string_view);

std::string refused(Parser parser, std::string_view text) {
  return refusal([&] { return parser(text, "f"); });
}

constexpr std::string_view plain_sample =
    "# title: \xC3\xA9t\xC3\xA9\nclosed\n0 0\n1 0 type=loop alpha=.3\n\nopen\n2 2e-1 tangent=-90\n3 3\n";
constexpr std::string_view pts_sample = "1\n3\n0 0\n1 0\n0 1\n1\n2\n5 5\n6 6\n";
constexpr std::string_view csv_sample =
    "# title: s\ncurve,x,y,closed,type,a\nouter,0,0,true,,\nouter,1,0,true,cusp,0.8\n\"in,ner\",2,3,false,,\n";
constexpr std::string_view toml_sample =
    "title = \"s\"\n[[curve]]\nclosed = true\npoints = [[0, 0], {x = 1, y = 2.5, type = \"cusp\", a = 0.8}]\n"
    "[[curve]]\npoints = [[3, 4]]\n";

}  // namespace

TEST_CASE("pts: closed curves, then open ones", "[datasets]") {
  const Drawing drawing = parse_pts(pts_sample, "f");
  REQUIRE(drawing.curves.size() == 2);
  CHECK(drawing.curves[0].closed);
  CHECK(drawing.curves[0].size() == 3);
  CHECK_FALSE(drawing.curves[1].closed);
  CHECK(drawing.curves[1].points[1] == Vec2(6.0, 6.0));
}

TEST_CASE("pts: refusals", "[datasets]") {
  CHECK_THAT(refused(parse_pts, "1\n3\n0 0\n1 0\n"), StartsWith("f:4: the file ends before point 3 of 3; "));
  CHECK_THAT(refused(parse_pts, "1\n2\n0 0\n1 0\n"), StartsWith("f:4: the file ends before the number of open curves"));
  CHECK_THAT(refused(parse_pts, "1\n2\n0 0\n1\n0\n"), StartsWith("f:4: \"1\" where point 2 of 2 is due; "));
  CHECK_THAT(refused(parse_pts, "1.5\n"), StartsWith("f:1: the number of closed curves = \"1.5\"; give an integer"));
  CHECK_THAT(refused(parse_pts, "-1\n"), StartsWith("f:1: the number of closed curves = \"-1\"; "));
  CHECK_THAT(refused(parse_pts, "1\n0\n0\n"), StartsWith("f:2: the number of points of a curve = \"0\"; "));
  CHECK_THAT(refused(parse_pts, "1\n99999999999999999999\n"), StartsWith("f:2: the number of points"));
  CHECK_THAT(refused(parse_pts, "1\n1\n0 nan\n0\n"), StartsWith("f:3: y = \"nan\" is not finite; "));
  CHECK_THAT(refused(parse_pts, "0\n0\n"), StartsWith("f: no curves; "));
  CHECK_THAT(refused(parse_pts, "0\n1\n1\n0 0\n7\n"), StartsWith("f:5: \"7\" after the last open curve; "));
}

TEST_CASE("pts: drawings published by others, where they are at hand", "[datasets]") {
  const std::filesystem::path folder = std::filesystem::path(KAPPABENCH_SHARED_DATA) / "ekappa-authors";
  if (!std::filesystem::is_directory(folder)) {
    WARN("skipped: no outside point data here");
    return;
  }
  const std::vector<Drawing> drawings = open_drawings(folder.string());
  REQUIRE(drawings.size() == 5);
  CHECK(drawings[0].id == "bear");
  CHECK(drawings[0].curves.size() == 28);
  CHECK(drawings[1].id == "bird");
  CHECK(drawings[1].curves.size() == 3);
  CHECK(drawings[1].curves[1].size() == 14);
}

TEST_CASE("csv: with and without a header", "[datasets]") {
  const Drawing bare = parse_csv("0,0\n 1 , 2.5\n\n3,-4\n", "f");
  REQUIRE(bare.curves.size() == 1);
  CHECK_FALSE(bare.curves[0].closed);
  CHECK(bare.curves[0].points[1] == Vec2(1.0, 2.5));

  const Drawing drawing = parse_csv(csv_sample, "f");
  CHECK(drawing.title == "s");
  REQUIRE(drawing.curves.size() == 2);
  CHECK(drawing.curves[0].closed);
  REQUIRE(drawing.curves[0].options.size() == 2);
  CHECK(drawing.curves[0].options[1].type == PointType::cusp);
  CHECK(drawing.curves[0].options[1].a == 0.8);
  CHECK_FALSE(drawing.curves[1].closed);
  CHECK(drawing.curves[1].options.empty());

  const Drawing angle = parse_csv("y,x,tangent\n1,0,180\n", "f");
  CHECK(angle.curves[0].points[0] == Vec2(0.0, 1.0));
  CHECK(*angle.curves[0].options[0].tangent == Approx(std::numbers::pi).epsilon(1e-15));
}

TEST_CASE("csv: as spreadsheets and instruments write it", "[datasets]") {
  const std::vector<Vec2> expected{{0, 0}, {1.5, 0.75}, {3.25, -1.1}};
  for (const std::string_view text :
       {"X,Y\r\n0,0\r\n1.5,0.75\r\n3.25,-1.1\r\n", "X;Y\r\n0,00;0,00\r\n1,50;0,75\r\n3,25;-1,1\r\n",
        "x;y\n0;0\n1.5;.75\n3.25;-1.1\n", "x\ty\n0\t0\n1,5\t0,75\n3,25\t-1,1\n", "0;0\n1,5;0,75\n3,25;-1,1\n",
        "x,y,\n0,0,\n1.5,0.75,\n3.25,-1.1,\n", "x,y\n0,0,,\n1.5,0.75,,\n3.25,-1.1,,\n",
        ",x,y\n0,0,0\n1,1.5,0.75\n2,3.25,-1.1\n", "x,y,z\n0,0,9\n1.5,0.75\n3.25,-1.1,\n",
        "# x_m,y_m,w_m\n0,0,1\n1.5,0.75,1\n3.25,-1.1,1\n",
        "\"Time [s]\",\"X [mm]\",\"Y [mm]\"\n0,0,0\n1,1.5,0.75\n2,3.25,-1.1\n", "0,0,\n1.5,0.75,\n3.25,-1.1,\n",
        "y (px);name;x (px)\n0;a;0\n0,75;\"b;c\";1,5\n-1,1;;3,25\n"}) {
    INFO(text);
    const Drawing drawing = parse_csv(text, "f");
    REQUIRE(drawing.curves.size() == 1);
    CHECK(drawing.curves[0].points == expected);
    CHECK(drawing.curves[0].options.empty());
  }
}

TEST_CASE("a text file is taken for columns where it cannot be plain points, and endings may shout", "[datasets]") {
  const ScratchFolder scratch;
  const std::vector<Vec2> expected{{0, 0}, {1.5, 0.75}};
  CHECK(read_drawing(file_in(scratch, "commas.txt", "0, 0\n1.5, 0.75\n")).curves[0].points == expected);
  CHECK(read_drawing(file_in(scratch, "header.txt", "X\tY\n0\t0\n1.5\t0.75\n")).curves[0].points == expected);
  CHECK(read_drawing(file_in(scratch, "plain.dat", "closed\n0\t0\n1.5\t0.75\n")).curves[0].closed);
  CHECK(read_drawing(file_in(scratch, "LOUD.CSV", "0;0\n1,5;0,75\n")).curves[0].points == expected);
}

TEST_CASE("csv: refusals", "[datasets]") {
  CHECK_THAT(refused(parse_csv, "0,0,0\n1,2,3\n"), StartsWith("f:1: 3 columns without names; "));
  CHECK_THAT(refused(parse_csv, "x,a\n"), StartsWith("f:1: no column x or no column y; "));
  CHECK_THAT(refused(parse_csv, "x,y,x\n"), StartsWith("f:1: column x is there twice; "));
  CHECK_THAT(refused(parse_csv, "x,y\n1\n"), StartsWith("f:2: 1 cells; this file has 2 columns"));
  CHECK_THAT(refused(parse_csv, "0,0\n1;2\n"), StartsWith("f:2: 1 cells; "));
  CHECK_THAT(refused(parse_csv, "x;y\n1,5;2,5;7\n"),
             StartsWith("f:2: 3 cells; this file has 2 columns, separated by semicolons"));
  CHECK_THAT(refused(parse_csv, "x;y\n1.000,5;2\n"), StartsWith("f:2: x = \"1.000,5\" is not a number; "));
  CHECK_THAT(refused(parse_csv, "# a,b\n0,0,1\n"), StartsWith("f:2: 3 columns without names; "));
  CHECK_THAT(refused(parse_csv, "u,v\n0,0\n"), StartsWith("f:1: no column x or no column y; "));
  CHECK_THAT(refused(parse_csv, "x,x_m,y\n0,0,0\n"), StartsWith("f:1: column x is there twice; "));
  CHECK_THAT(refused(parse_csv, "0,0\n1,\n"), StartsWith("f:2: y = \"\" is not a number; "));
  CHECK_THAT(refused(parse_csv, "0,0\n1,inf\n"), StartsWith("f:2: y = \"inf\" is not finite; "));
  CHECK_THAT(refused(parse_csv, "x,y,closed\n0,0,yes\n"), StartsWith("f:2: closed = \"yes\"; give true or false"));
  CHECK_THAT(refused(parse_csv, "x,y,closed\n0,0,true\n1,1,false\n"), StartsWith("f:3: closed = false differs"));
  CHECK_THAT(refused(parse_csv, "curve,x,y\na,0,0\nb,1,1\na,2,2\n"), StartsWith("f:4: curve \"a\" goes on after"));
  CHECK_THAT(refused(parse_csv, "curve,x,y\n\"a,0,0\n"), StartsWith("f:2: a quote without its end; "));
  CHECK_THAT(refused(parse_csv, "x,y\n"), StartsWith("f: no points; "));
}

TEST_CASE("toml: points as pairs and as tables", "[datasets]") {
  const Drawing drawing = parse_toml(toml_sample, "f");
  CHECK(drawing.title == "s");
  REQUIRE(drawing.curves.size() == 2);
  CHECK(drawing.curves[0].closed);
  CHECK(drawing.curves[0].points[1] == Vec2(1.0, 2.5));
  CHECK(drawing.curves[0].options[1].type == PointType::cusp);
  CHECK(drawing.curves[0].options[1].a == 0.8);
  CHECK_FALSE(drawing.curves[1].closed);
  CHECK(drawing.curves[1].options.empty());

  const Drawing tables = parse_toml("[[curve]]\n[[curve.points]]\nx = 1\ny = 2\ntangent = 90\n", "f");
  CHECK(*tables.curves[0].options[0].tangent == Approx(std::numbers::pi / 2).epsilon(1e-15));
}

TEST_CASE("toml: an integer that no double holds exactly is rounded", "[datasets]") {
  const Drawing drawing = parse_toml("[[curve]]\npoints = [[99999999999999990, 1]]\n", "f");
  CHECK(drawing.curves[0].points[0].x() == 99999999999999990.0);
}

TEST_CASE("toml: refusals", "[datasets]") {
  CHECK_THAT(refused(parse_toml, "[[curve]]\npoints = [[0, 0]\n"), StartsWith("f:"));
  CHECK_THAT(refused(parse_toml, "\nname = \"s\"\n"), StartsWith("f:2: unknown key \"name\"; known are title"));
  CHECK_THAT(refused(parse_toml, "title = 3\n"), StartsWith("f:1: title is not a text; "));
  CHECK_THAT(refused(parse_toml, "title = \"\"\"a\nb\"\"\"\n"), StartsWith("f:1: title has several lines; "));
  CHECK_THAT(refused(parse_toml, "curve = 3\n"), StartsWith("f:1: curve is not an array; "));
  CHECK_THAT(refused(parse_toml, "curve = [3]\n"), StartsWith("f:1: curve is not a table; "));
  CHECK_THAT(refused(parse_toml, "title = \"s\"\n"), StartsWith("f: no curves; "));
  CHECK_THAT(refused(parse_toml, "[[curve]]\nclosed = true\n"), StartsWith("f:1: a curve without points; "));
  const std::string head = "[[curve]]\n";
  CHECK_THAT(refused(parse_toml, head + "closed = 1\n"), StartsWith("f:2: closed is not a boolean; "));
  CHECK_THAT(refused(parse_toml, head + "colour = 1\n"), StartsWith("f:2: unknown key \"colour\" of a curve; "));
  CHECK_THAT(refused(parse_toml, head + "points = 3\n"), StartsWith("f:2: points is not an array; "));
  CHECK_THAT(refused(parse_toml, head + "points = [\n[0, 0],\n[1]]\n"), StartsWith("f:4: a point of 1 numbers; "));
  CHECK_THAT(refused(parse_toml, head + "points = [[0, nan]]\n"), StartsWith("f:2: y is not a finite number; "));
  CHECK_THAT(refused(parse_toml, head + "points = [[0, \"1\"]]\n"), StartsWith("f:2: y is not a finite number; "));
  CHECK_THAT(refused(parse_toml, head + "points = [{x = 0}]\n"), StartsWith("f:2: a point without x or y; "));
  CHECK_THAT(refused(parse_toml, head + "points = [7]\n"), StartsWith("f:2: this is not a point; "));
  CHECK_THAT(refused(parse_toml, head + "points = [{x = 0, y = 0, z = 0}]\n"), StartsWith("f:2: unknown key \"z\""));
  CHECK_THAT(refused(parse_toml, head + "points = [{x = 0, y = 0, type = \"kink\"}]\n"), StartsWith("f:2: type = "));
}

TEST_CASE("a file cut off or damaged at any byte gives points or a message, never a crash", "[datasets]") {
  const std::vector<std::pair<Parser, std::string_view>> samples{
      {parse_plain, plain_sample}, {parse_pts, pts_sample}, {parse_csv, csv_sample}, {parse_toml, toml_sample}};
  const auto survives = [](Parser parser, std::string_view text) {
    Drawing drawing;
    const std::string message = refusal([&] { return drawing = parser(text, "f"); });
    if (!message.empty()) return message.starts_with("f:") && message.find('\n') == std::string::npos;
    for (const Input& curve : drawing.curves) {
      for (const Vec2& point : curve.points) {
        if (!point.allFinite()) return false;
      }
      if (curve.points.empty() || (!curve.options.empty() && curve.options.size() != curve.points.size())) return false;
    }
    return !drawing.curves.empty();
  };
  for (const auto& [parser, sample] : samples) {
    REQUIRE(refused(parser, sample).empty());
    for (std::size_t cut = 0; cut < sample.size(); ++cut) {
      CAPTURE(sample, cut);
      CHECK(survives(parser, sample.substr(0, cut)));
      for (const char damage : {'\0', '\xFF', '\n', '=', '"', '[', '#', '-', '9'}) {
        std::string damaged(sample);
        damaged[cut] = damage;
        CHECK(survives(parser, damaged));
      }
    }
  }
}

TEST_CASE("the ending of the name tells the format", "[datasets]") {
  const ScratchFolder scratch;
  CHECK(read_drawing(file_in(scratch, "p.txt", plain_sample)).curves.size() == 2);
  CHECK(read_drawing(file_in(scratch, "plain-without-ending", plain_sample)).id == "plain-without-ending");
  CHECK(read_drawing(file_in(scratch, "p.pts", pts_sample)).curves.size() == 2);
  CHECK(read_drawing(file_in(scratch, "c.csv", csv_sample)).curves.size() == 2);
  CHECK(read_drawing(file_in(scratch, "t.toml", toml_sample)).curves.size() == 2);
}
