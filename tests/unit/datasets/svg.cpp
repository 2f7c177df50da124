// Curves of SVG documents. Expected numbers are worked out by hand or from the parametric equations of circle and
// ellipse, never by the code under test.
#include "datasets/curves/svg.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/unit/datasets/scratch.hpp"

using namespace kappabench;

namespace {

std::string document(const std::string& inside, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attributes + ">\n" + inside + "\n</svg>\n";
}
std::string path(const std::string& data) { return "<path d=\"" + data + "\"/>"; }

std::vector<Outline> curves(const std::string& inside) { return read_svg(document(inside), "f.svg"); }
std::string refused(const std::string& text) {
  return refusal([&] { return read_svg(text, "f.svg"); });
}
std::string refused_path(const std::string& data) { return refused(document(path(data))); }

/// A number of the drawing as it is in the file, where y points down.
Vec2 down(const Vec2& p) { return {p.x(), -p.y()}; }

using Points = std::vector<Vec2>;

Points controls(const Segment& segment) {
  const ExactForm exact = segment.exact();
  REQUIRE(std::holds_alternative<PolynomialForm>(exact));
  Points points;
  for (const Vec2& p : std::get<PolynomialForm>(exact).control_points) points.push_back(down(p));
  return points;
}

std::string text_of(const Points& points) {
  std::string text;
  for (const Vec2& p : points) text += fmt::format("({:.12g} {:.12g})", p.x() + 0.0, p.y() + 0.0);
  return text;
}
std::string text_of(const Outline& outline) {
  std::string text;
  for (const SegmentPtr& segment : outline.segments) text += (text.empty() ? "" : " ") + text_of(controls(*segment));
  return text + (outline.closed ? " z" : "");
}
/// "(0 0)(1 0) z": control points of each segment; subpaths with " | " between.
std::string drawn(const std::string& inside) {
  std::string text;
  for (const Outline& outline : curves(inside)) text += (text.empty() ? "" : " | ") + text_of(outline);
  return text;
}
std::string drawn_path(const std::string& data) { return drawn(path(data)); }

/// The ellipse that the tests know: its point at the angle w, radians.
struct Ellipse {
  Vec2 centre, radii;
  double rotation;  ///< radians

  [[nodiscard]] Vec2 at(double w) const {
    const double u = radii.x() * std::cos(w), v = radii.y() * std::sin(w);
    return {centre.x() + u * std::cos(rotation) - v * std::sin(rotation),
            centre.y() + u * std::sin(rotation) + v * std::cos(rotation)};
  }
};

constexpr double pi = std::numbers::pi;

/// "M .. A .." from the angle `from` to `to`.
std::string arc_data(const Ellipse& e, double from, double to) {
  const Vec2 start = e.at(from), end = e.at(to);
  return fmt::format("M{:.17g} {:.17g}A{:.17g} {:.17g} {:.17g} {} {} {:.17g} {:.17g}", start.x(), start.y(),
                     e.radii.x(), e.radii.y(), e.rotation * 180.0 / pi, std::abs(to - from) > pi ? 1 : 0,
                     to > from ? 1 : 0, end.x(), end.y());
}

/// The largest distance between a segment and `at(t)`, y down.
template <class At>
double gap(const Segment& segment, const At& at) {
  double largest = 0.0;
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0;
    largest = std::max(largest, (down(segment.jet(t, 0).position()) - at(t)).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("SVG: every command of path data, absolute and relative", "[svg]") {
  CHECK(drawn_path("M1 2L3 4") == "(1 2)(3 4)");
  CHECK(drawn_path("m1 2l3 4") == "(1 2)(4 6)");
  CHECK(drawn_path("M1 2 3 4 5 4") == "(1 2)(3 4) (3 4)(5 4)");
  CHECK(drawn_path("m1 2 3 4 5 -4") == "(1 2)(4 6) (4 6)(9 2)");
  CHECK(drawn_path("M1 2H5h-1 2V7v1 1") == "(1 2)(5 2) (5 2)(4 2) (4 2)(6 2) (6 2)(6 7) (6 7)(6 8) (6 8)(6 9)");
  CHECK(drawn_path("M1 1C2 2 3 2 4 1") == "(1 1)(2 2)(3 2)(4 1)");
  CHECK(drawn_path("M1 1c1 1 2 1 3 0 1 1 2 1 3 0") == "(1 1)(2 2)(3 2)(4 1) (4 1)(5 2)(6 2)(7 1)");
  CHECK(drawn_path("M1 1C2 2 3 2 4 1S6 0 7 1s2 1 3 0") ==
        "(1 1)(2 2)(3 2)(4 1) (4 1)(5 0)(6 0)(7 1) (7 1)(8 2)(9 2)(10 1)");
  CHECK(drawn_path("M1 1Q2 3 3 1T5 1t2 0") == "(1 1)(2 3)(3 1) (3 1)(4 -1)(5 1) (5 1)(6 3)(7 1)");
  CHECK(drawn_path("M1 1q1 2 2 0 1 2 2 0") == "(1 1)(2 3)(3 1) (3 1)(4 3)(5 1)");
  // After anything else than its own kind the first control point is where the pen is.
  CHECK(drawn_path("M1 1S2 2 3 1") == "(1 1)(1 1)(2 2)(3 1)");
  CHECK(drawn_path("M1 1Q2 3 3 1S5 0 6 1") == "(1 1)(2 3)(3 1) (3 1)(3 1)(5 0)(6 1)");
  CHECK(drawn_path("M1 1C2 2 3 2 4 1T6 1") == "(1 1)(2 2)(3 2)(4 1) (4 1)(4 1)(6 1)");
  CHECK(drawn_path("M1 1T3 1T5 5") == "(1 1)(1 1)(3 1) (3 1)(5 1)(5 5)");
}

TEST_CASE("SVG: subpaths, and what closes them", "[svg]") {
  CHECK(drawn_path("M0 0H2V2Z") == "(0 0)(2 0) (2 0)(2 2) (2 2)(0 0) z");
  // The last point is the first one: no segment more.
  CHECK(drawn_path("M0 0H2V2L0 0z") == "(0 0)(2 0) (2 0)(2 2) (2 2)(0 0) z");
  CHECK(drawn_path("M0 0H2V2L0 0") == "(0 0)(2 0) (2 0)(2 2) (2 2)(0 0)");
  CHECK(drawn_path("M0 0H1M5 5h1m1 1v1") == "(0 0)(1 0) | (5 5)(6 5) | (7 6)(7 7)");
  // After z the pen is where the subpath started, with or without a move.
  CHECK(drawn_path("m1 1h1v1zm5 5h1") == "(1 1)(2 1) (2 1)(2 2) (2 2)(1 1) z | (6 6)(7 6)");
  CHECK(drawn_path("M1 1h1v1zl-1 0") == "(1 1)(2 1) (2 1)(2 2) (2 2)(1 1) z | (1 1)(0 1)");
  // Rounded coordinates close the curve; a step that is meant does not.
  CHECK(drawn_path("M0 0C1 1 2 1 3 0C2 -1 1 -1 1e-7 0z") == "(0 0)(1 1)(2 1)(3 0) (3 0)(2 -1)(1 -1)(0 0) z");
  CHECK(drawn_path("M0 0L10 0L10 10L0 .001z") == "(0 0)(10 0) (10 0)(10 10) (10 10)(0 0.001) (0 0.001)(0 0) z");
}

TEST_CASE("SVG: numbers as the standard writes them", "[svg]") {
  CHECK(drawn_path("M.5.5-1-2") == "(0.5 0.5)(-1 -2)");
  CHECK(drawn_path("M1e-3,1E+1 , 2.5e0\n\t-3.") == "(0.001 10)(2.5 -3)");
  CHECK(drawn_path("M+1-.5L2+3") == "(1 -0.5)(2 3)");
  CHECK_THAT(refused_path("M0 0 1-1.5.5"), ContainsSubstring("f.svg:2: the end where y is needed"));
  CHECK(drawn("<path d='M 0,0\nC 1,1\n  2,1\n  3,0'/>") == "(0 0)(1 1)(2 1)(3 0)");
}

TEST_CASE("SVG: what has no length is not there", "[svg]") {
  CHECK(drawn_path("M1 1L1 1L2 2H2") == "(1 1)(2 2)");
  CHECK(drawn_path("M1 1C1 1 1 1 1 1L2 2") == "(1 1)(2 2)");
  CHECK(drawn_path("M9 9M1 1L2 2M5 5z") == "(1 1)(2 2)");
  CHECK(drawn_path("M0 0A1 1 0 0 0 0 0L1 0") == "(0 0)(1 0)");
  // Control points that coincide with an end are legal.
  CHECK(drawn_path("M0 0C0 0 3 1 3 1") == "(0 0)(0 0)(3 1)(3 1)");
  CHECK_THAT(refused_path("M1 1h0"), ContainsSubstring("f.svg: nothing is drawn"));
}

TEST_CASE("SVG: elliptic arcs are those of the parametric equation", "[svg]") {
  const Ellipse ellipses[] = {{{3, -2}, {5, 5}, 0.0}, {{-10, 4}, {7, 2}, 0.7}, {{0.25, 0}, {1, 30}, -2.0}};
  const std::pair<double, double> angles[] = {{0.3, 1.2}, {1.2, 0.3}, {-1.0, 3.5}, {4.0, -1.0}, {0.1, 6.2}, {2.0, 5.0}};
  for (const Ellipse& e : ellipses)
    for (const auto& [from, to] : angles) {
      const double first = from, last = to;
      const std::string data = arc_data(e, first, last);
      CAPTURE(data);
      const std::vector<Outline> found = curves(path(data));
      REQUIRE(found.size() == 1);
      REQUIRE(found[0].segments.size() == 1);
      CHECK(std::holds_alternative<EllipticArcForm>(found[0].segments[0]->exact()));
      // Near the whole turn the ends decide the centre, by a factor of their angle.
      CHECK(gap(*found[0].segments[0], [&](double t) { return e.at(first + t * (last - first)); }) <
            1e-12 * e.radii.maxCoeff());
    }
}

TEST_CASE("SVG: all four arcs between two points", "[svg]") {
  // The circles of radius 5 through (0, 0) and (6, 0) have their centres at (3, 4) and (3, -4).
  const auto middle = [](const std::string& flags) {
    const std::vector<Outline> found = curves(path("M0 0A5 5 0 " + flags + " 6 0"));
    return down(found.at(0).segments.at(0)->jet(0.5, 0).position());
  };
  CHECK((middle("0 0") - Vec2(3, 1)).norm() < 1e-14);
  CHECK((middle("0 1") - Vec2(3, -1)).norm() < 1e-14);
  CHECK((middle("1 0") - Vec2(3, 9)).norm() < 1e-14);
  CHECK((middle("1 1") - Vec2(3, -9)).norm() < 1e-14);
  // Flags need nothing around them, and repeat with the command.
  CHECK((middle("00") - Vec2(3, 1)).norm() < 1e-14);
  const std::vector<Outline> two = curves(path("M0 0a5 5 0 016 0 5 5 0 10.5.5"));
  REQUIRE(two.at(0).segments.size() == 2);
  CHECK((down(two[0].segments[0]->jet(0.5, 0).position()) - Vec2(3, -1)).norm() < 1e-14);
  CHECK((down(two[0].segments[1]->jet(1.0, 0).position()) - Vec2(6.5, 0.5)).norm() < 1e-13);
}

TEST_CASE("SVG: arcs of radii that are zero, negative, too small, endless", "[svg]") {
  CHECK(drawn_path("M0 0A0 5 30 1 1 6 0") == "(0 0)(6 0)");
  CHECK(drawn_path("M0 0A5 0 30 1 1 6 0") == "(0 0)(6 0)");
  const auto half_circle = [](const std::string& data) {
    const Ellipse e{{3, 0}, {3, 3}, 0.0};
    return gap(*curves(path(data)).at(0).segments.at(0), [&](double t) { return e.at(pi + pi * t); });
  };
  CHECK(half_circle("M0 0A1 1 0 0 1 6 0") < 1e-14);
  CHECK(half_circle("M0 0A-3 -3 0 0 1 6 0") < 1e-14);
  CHECK(half_circle("M0 0A3 3 70 0 1 6 0") < 1e-14);
  // Grown in proportion: (1, 2) along x is (3, 6).
  const Ellipse grown{{3, 0}, {3, 6}, 0.0};
  CHECK(gap(*curves(path("M0 0A1 2 0 0 1 6 0")).at(0).segments.at(0), [&](double t) { return grown.at(pi + pi * t); }) <
        1e-14);
  CHECK(drawn_path("M0 0A1e10 1e10 0 0 1 6 0") == "(0 0)(6 0)");
  const std::string huge = refused_path("M0 0A1e300 1e300 0 1 1 6 0");
  CHECK_THAT(huge, ContainsSubstring("do not fit a double"));
}

TEST_CASE("SVG: shapes", "[svg]") {
  CHECK(drawn("<line x1='1' y1='2' x2='3' y2='4'/>") == "(1 2)(3 4)");
  CHECK(drawn("<polyline points='0,0 1,0 1-1'/>") == "(0 0)(1 0) (1 0)(1 -1)");
  CHECK(drawn("<polygon points='0 0, 1 0, 1 1'/>") == "(0 0)(1 0) (1 0)(1 1) (1 1)(0 0) z");
  CHECK(drawn("<rect x='1' y='2' width='3' height='4'/>") == "(1 2)(4 2) (4 2)(4 6) (4 6)(1 6) (1 6)(1 2) z");
  CHECK(drawn("<line x2='1in' y2='25.4mm'/>") == "(0 0)(96 96)");

  const std::vector<Outline> round = curves("<rect width='10' height='6' rx='2'/>");
  REQUIRE(round.at(0).segments.size() == 8);
  const Ellipse corner{{8, 2}, {2, 2}, 0.0};
  CHECK(gap(*round[0].segments[1], [&](double t) { return corner.at(-pi / 2 + t * pi / 2); }) < 1e-14);
  CHECK(curves("<rect width='10' height='6' rx='99' ry='99'/>").at(0).segments.size() == 4);

  for (const std::string shape : {"<circle cx='1' cy='-2' r='3'/>", "<ellipse cx='1' cy='-2' rx='3' ry='3'/>"}) {
    const std::vector<Outline> circle = curves(shape);
    REQUIRE(circle.at(0).segments.size() == 4);
    CHECK(circle[0].closed);
    const Ellipse e{{1, -2}, {3, 3}, 0.0};
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(gap(*circle[0].segments[i], [&](double t) { return e.at((static_cast<double>(i) + t) * pi / 2); }) < 1e-14);
  }
  CHECK(curves("<circle r='0'/><rect width='-1' height='2'/><line x2='1'/>").size() == 1);
}

TEST_CASE("SVG: transforms of an element and of those around it", "[svg]") {
  const auto line = [](const std::string& transform) {
    return drawn("<path transform='" + transform + "' d='M1 2L3 5'/>");
  };
  CHECK(line("translate(10)") == "(11 2)(13 5)");
  CHECK(line("translate(10,20)") == "(11 22)(13 25)");
  CHECK(line("scale(2)") == "(2 4)(6 10)");
  CHECK(line(" scale( 2 , -3 ) ") == "(2 -6)(6 -15)");
  CHECK(line("matrix(1 2 3 4 5 6)") == "(12 16)(23 32)");
  CHECK(line("rotate(90)") == "(-2 1)(-5 3)");
  CHECK(line("rotate(-90 1 2)") == "(1 2)(4 0)");
  CHECK(line("rotate(450,1,2)") == "(1 2)(-2 4)");
  CHECK(line("skewX(45)") == "(3 2)(8 5)");
  CHECK(line("skewY(45)") == "(1 3)(3 8)");
  CHECK(line("none") == "(1 2)(3 5)");
  // The last one first.
  CHECK(line("translate(10 0) scale(2)") == "(12 4)(16 10)");
  CHECK(line("scale(2),translate(10 0)scale(1-1)") == "(22 -4)(26 -10)");
  const Ellipse unit{{0, 0}, {1, 1}, 30.0 * pi / 180.0};
  const Vec2 turned =
      down(curves("<path transform='rotate(30)' d='M0 0H1'/>").at(0).segments.at(0)->jet(1, 0).position());
  CHECK((turned - unit.at(0.0)).norm() < 1e-15);

  CHECK(drawn("<g transform='translate(1 1)'><a><g transform='scale(2)'><path transform='rotate(90)' d='M0 0H1'/>"
              "</g></a></g>") == "(1 1)(1 3)");
  // Not rendered, says the standard.
  CHECK(drawn("<g transform='scale(0)'><path d='M0 0H1'/></g><path d='M0 0H2'/>") == "(0 0)(2 0)");
}

TEST_CASE("SVG: an arc under any affine map is an arc", "[svg]") {
  const Ellipse e{{3, 1}, {5, 2}, 0.4};
  // x, y -> 2x + 0.5y + 7, -x + 3y - 4, and a mirror image of it.
  for (const double sign : {1.0, -1.0}) {
    const std::string transform = fmt::format("matrix({} -1 {} 3 7 -4)", sign * 2.0, sign * 0.5);
    const auto found = curves("<path transform='" + transform + "' d='" + arc_data(e, 0.5, 2.5) + "'/>");
    CHECK(std::holds_alternative<EllipticArcForm>(found.at(0).segments.at(0)->exact()));
    CHECK(gap(*found[0].segments[0], [&](double t) {
            const Vec2 p = e.at(0.5 + 2.0 * t);
            return Vec2(sign * (2.0 * p.x() + 0.5 * p.y()) + 7.0, -p.x() + 3.0 * p.y() - 4.0);
          }) < 1e-13);
  }
}

TEST_CASE("SVG: what is defined is not drawn, what is used is", "[svg]") {
  const std::string one = "<path id='one' d='M0 0H1'/>";
  for (const std::string kind : {"defs", "symbol", "clipPath", "mask", "marker", "pattern"})
    CHECK(drawn("<" + kind + ">" + one + "</" + kind + "><path d='M5 5H6'/>") == "(5 5)(6 5)");
  CHECK(drawn("<defs>" + one + "</defs><use href='#one' x='2' y='3'/>") == "(2 3)(3 3)");
  CHECK(drawn("<defs>" + one + "</defs><use xlink:href='#one' transform='scale(2)' x='1'/>") == "(2 0)(4 0)");
  CHECK(drawn(one + "<use href='#one' y='3'/>") == "(0 0)(1 0) | (0 3)(1 3)");
  CHECK(drawn("<symbol id='s'>" + one + "<path d='M0 1H1'/></symbol><use href='#s' x='1'/>") ==
        "(1 0)(2 0) | (1 1)(2 1)");
  CHECK(drawn("<g display='none'>" + one + "</g><g style='fill:red; display : none'>" + one +
              "</g><path d='M1 0H9'/>") == "(1 0)(9 0)");

  CHECK_THAT(refused(document("<g id='g'>\n<use href='#g'/></g>")), ContainsSubstring("f.svg:3: uses within uses"));
  CHECK_THAT(refused(document("<use href='#nobody'/>")),
             ContainsSubstring("f.svg:2: use of \"#nobody\", which is not"));
  CHECK_THAT(refused(document("<use href='other.svg#a'/>")), ContainsSubstring("a use names a part of the same file"));
  CHECK_THAT(refused(document("<svg viewBox='0 0 1 1'>" + one + "</svg>")), ContainsSubstring("with a viewBox inside"));
  CHECK(drawn("<svg x='1' y='2'>" + one + "</svg>") == "(1 2)(2 2)");
}

TEST_CASE("SVG: y points up, units are those of the outermost viewBox", "[svg]") {
  const auto found =
      read_svg(document(path("M10 20H30"), " width='210mm' height='297mm' viewBox='0 0 210 297'"), "f.svg");
  CHECK(found.at(0).segments.at(0)->jet(0.0, 0).position() == Vec2(10.0, -20.0));
  CHECK(found.at(0).segments.at(0)->jet(1.0, 0).position() == Vec2(30.0, -20.0));
}

TEST_CASE("SVG: a file as drawing programs write them", "[svg]") {
  const std::string text =
      "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\r\n"
      "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\" [\r\n"
      "  <!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\r\n]>\r\n"
      "<!-- made by hand -->\r\n"
      "<svg:svg xmlns:svg='http://www.w3.org/2000/svg' xmlns:inkscape='i' xmlns:sodipodi='s' width='100%'\r\n"
      "   viewBox='0 0 10 10' inkscape:version='1.2'>\r\n"
      "  <sodipodi:namedview id='base' pagecolor='#fff'><inkscape:grid type='xygrid'/></sodipodi:namedview>\r\n"
      "  <svg:style>.a { stroke: red }</svg:style>\r\n"
      "  <svg:metadata><path d='nonsense'/></svg:metadata>\r\n"
      "  <svg:g inkscape:label=\"Layer 1\" inkscape:groupmode=\"layer\" transform=\"translate(0,-1)\">\r\n"
      "    <svg:path style=\"fill:none;stroke:#000000;stroke-width:0.26458332px\"\r\n"
      "       d=\"m 1,2\r\n c 1,1 2,1\r\n 3,0 z\"\r\n       inkscape:original-d=\"m 0,0\" "
      "sodipodi:nodetypes=\"cc\"/>\r\n"
      "    <svg:text x='1'>words</svg:text>\r\n"
      "  </svg:g>\r\n</svg:svg>\r\n";
  const std::vector<Outline> found = read_svg(text, "f.svg");
  REQUIRE(found.size() == 1);
  CHECK(text_of(found[0]) == "(1 1)(2 2)(3 2)(4 1) (4 1)(1 1) z");
}

TEST_CASE("SVG: what is wrong is refused with its line", "[svg]") {
  const std::pair<std::string, std::string> wrong[] = {
      {"L1 1", "f.svg:2: path data start with \"L1 1\"; they start with M or m"},
      {"1 1", "f.svg:2: \"1 1\" where a command is needed; path data have M, L"},
      {"M1 1X2 2", "f.svg:2: \"X2 2\" where a command is needed"},
      {"M1 1\n\nL2 2\nL3", "f.svg:5: the end where y is needed"},
      {"M1 1L", "the end where x is needed; give a decimal number"},
      {"M1 1zz1 1", "\"1 1\" where a command is needed"},
      {"M0 0A1 1 0 2 0 1 1", "f.svg:2: \"2 0 1 1\" where the flag of a large arc is needed; give 0 or 1"},
      {"M0 0A1 1 0 0", "the end where the flag of a sweep is needed"},
      {"M0 0L1e400 0", "f.svg:2: x = \"1e400\" does not fit a double"},
      {"M0 0Lnan 0", "\"nan 0\" where x is needed"},
      {"M0 0Linf 0", "\"inf 0\" where x is needed"},
      {"M0 0L0x10 0", "\"x10 0\" where y is needed"},
      {"M1e308 0l1e308 0", "f.svg:2: coordinates that do not fit a double"},
      {"M0 0 &bomb; 1", "\"&bomb; 1\" where a command is needed"},
  };
  for (const auto& [data, what] : wrong) {
    CAPTURE(data);
    CHECK_THAT(refused_path(data), ContainsSubstring(what));
  }
  const auto transform = [](const std::string& value) {
    return refused(document("<g\n transform='" + value + "'><path d='M0 0H1'/></g>"));
  };
  CHECK_THAT(transform("turn(3)"), ContainsSubstring("f.svg:3: \"turn(3)\" is no transform; known are matrix"));
  CHECK_THAT(transform("rotate(1 2)"), ContainsSubstring("f.svg:3: rotate of 2 numbers; rotate takes 1 or 3"));
  CHECK_THAT(transform("matrix(1 2 3 4 5 6 7 8 9)"), ContainsSubstring("matrix takes 6"));
  CHECK_THAT(transform("scale()"), ContainsSubstring("scale of 0 numbers"));
  CHECK_THAT(transform("scale(2"), ContainsSubstring("scale without )"));
  CHECK_THAT(transform("scale 2"), ContainsSubstring("scale without ("));
  CHECK_THAT(transform("scale(1e300) scale(1e300)"), ContainsSubstring("is not finite"));
  CHECK_THAT(refused(document("<circle r='10%'/>")),
             ContainsSubstring("f.svg:2: r = \"10%\"; give a number, or one with"));
  CHECK_THAT(refused(document("<circle r='mm'/>")), ContainsSubstring("f.svg:2: r = "));
  CHECK_THAT(refused(document("<polygon points='1 2 3'/>")), ContainsSubstring("the end where y is needed"));
}

TEST_CASE("SVG: hostile documents are refused with one line", "[svg]") {
  CHECK_THAT(refused("<svg>\n<g>\n</svg>"), ContainsSubstring("f.svg:3: not XML"));
  CHECK_THAT(refused("<svg"), ContainsSubstring("not XML"));
  CHECK_THAT(refused("<html>\n</html>"), ContainsSubstring("f.svg:1: the outermost element is \"html\"; of an SVG"));
  CHECK_THAT(refused(document("")), ContainsSubstring("f.svg: nothing is drawn; curves are path"));
  CHECK_THAT(refused("<!DOCTYPE svg [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;'>]>\n"
                     "<svg><path d='&b;'/></svg>"),
             ContainsSubstring("f.svg:2: \"&b;\" where a command is needed"));

  std::string deep = "<svg>";
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  CHECK_THAT(refused(deep), ContainsSubstring("not XML"));
  for (int i = 0; i < 100000; ++i) deep += "</g>";
  CHECK_THAT(refused(deep + "</svg>"), ContainsSubstring("elements more than 256 deep; ungroup"));

  // Ten uses of ten uses of ...: 10^12 lines.
  std::string bomb = "<defs><path id='u0' d='M0 0H1'/>";
  for (int level = 1; level <= 12; ++level) {
    bomb += fmt::format("<g id='u{}'>", level);
    for (int i = 0; i < 10; ++i) bomb += fmt::format("<use href='#u{}'/>", level - 1);
    bomb += "</g>";
  }
  CHECK_THAT(refused(document(bomb + "</defs><use href='#u12'/>")), ContainsSubstring("more than 1000000 elements"));

  std::string endless = "M0 0";
  for (int i = 0; i < 1000001; ++i) endless += "h1";
  CHECK_THAT(refused_path(endless), ContainsSubstring("f.svg:2: more than 1000000 segments"));
}
