// The verb hermite as scripts call it: two points, their tangents and curvatures, and the curve between.
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/intrinsic.hpp"
#include "tests/catch.hpp"
#include "tests/integration/program.hpp"

using namespace kappabench;
using namespace kappabench::test;
using nlohmann::json;

namespace {

struct End {
  double x, y, degrees;
  std::optional<double> curvature{};
};

/// The angle between `angle`, in radians, and that of the end.
double turned(double angle, const End& end) {
  return std::abs(std::remainder(angle - end.degrees * std::numbers::pi / 180.0, 2.0 * std::numbers::pi));
}

/// Digits that read back to the same number.
std::string digits(double value) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string text(const End& end) {
  std::string result = digits(end.x) + "," + digits(end.y) + "," + digits(end.degrees);
  if (end.curvature) result += "," + digits(*end.curvature);
  return result;
}

struct Case {
  End from, to;
  double chord() const { return std::hypot(to.x - from.x, to.y - from.y); }
  std::string arguments() const { return "hermite --from " + text(from) + " --to " + text(to); }
};

/// Arches, S-shapes, the same backwards; signs and places of all kinds.
const std::vector<Case> without_curvature{{{0, 0, 30}, {2, 1, -45}},           {{0, 0, 40}, {1, 0, 40}},
                                          {{1, 0, 220}, {0, 0, 220}},          {{-1.5, -2, -100.5}, {-3, 0.25, 120}},
                                          {{1000, 1e-3, 765}, {1001, 0, -30}}, {{0, 0, 0}, {3, 0, 0}}};
/// Of monotone curvature, as intrinsic wants it.
const std::vector<Case> with_curvatures{{{0, 0, -20, 0.3}, {1, 0, 40, 2.2}},
                                        {{1, 0, 220, -2.2}, {0, 0, 160, -0.3}},
                                        {{0, 0, 30, -5.0}, {1, 0, 25, 6.0}},
                                        {{-2, -3, 70, 0.15}, {-2, -1, 130, 1.1}}};

SegmentPtr segment(const json& s) {
  const Vec2 start(s.at("start").at(0).get<double>(), s.at("start").at(1).get<double>());
  if (s.at("type") == "clothoid")
    return std::make_shared<ClothoidSegment>(
        ClothoidForm{start, s.at("angle"), s.at("curvature"), s.at("curvature_rate"), s.at("length")});
  REQUIRE(s.at("type") == "intrinsic");
  return std::make_shared<IntrinsicSegment>(IntrinsicForm{start, s.at("angle"), s.at("length"), s.at("degree"),
                                                          s.at("knots").get<std::vector<double>>(),
                                                          s.at("control_curvatures").get<std::vector<double>>()});
}

void check_end(const Jet& jet, const End& end, double chord) {
  CHECK((jet.position() - Vec2(end.x, end.y)).norm() <= 1e-12 * chord);
  CHECK(turned(tangent_angle(jet), end) <= 1e-12);
  if (end.curvature) CHECK(curvature(jet) == Approx(*end.curvature).epsilon(1e-12));
}

/// The curve that the JSON alone gives meets the data.
void check_json(const std::string& out, const Case& data) {
  const json curve = json::parse(out).at(0);
  CHECK(curve.at("format") == "kappabench-curve");
  CHECK(curve.at("outcome") == "converged");
  CHECK(curve.at("closed") == false);
  REQUIRE(curve.at("nodes").size() == 2);
  check_end(segment(curve.at("segments").front())->jet(0.0, 2), data.from, data.chord());
  check_end(segment(curve.at("segments").back())->jet(1.0, 2), data.to, data.chord());
}

std::vector<double> numbers(const std::string& line, char separator) {
  std::vector<double> result;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) result.push_back(std::stod(field));
  return result;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

const std::string feasible = "hermite --from 0,0,-20,0.3 --to 1,0,40,2.2 ";
const std::string infeasible = "hermite --from 0,0,-20,0.3 --to 1,0,40,1.55 ";

}  // namespace

TEST_CASE("the JSON of hermite meets points, tangents and curvatures") {
  const ScratchFolder folder;
  for (const std::string scheme : {"intrinsic", "clothoid3", "clothoid3:compat=true"})
    for (const auto* cases : {&without_curvature, &with_curvatures})
      for (const Case& data : *cases) {
        INFO(data.arguments() << " --scheme " << scheme);
        const Ran ran = run(folder, data.arguments() + " --scheme " + scheme);
        const bool wild = !json::parse(ran.out).at(0).at("warnings").empty();
        CHECK(wild == (ran.err.find(": warning ") != std::string::npos));
        CHECK((wild || ran.err.empty()));
        REQUIRE(ran.status == 0);
        check_json(ran.out, data);
      }
}

TEST_CASE("hermite fits with intrinsic unless told otherwise, and a known curve has its known length") {
  const ScratchFolder folder;
  const Ran ran = run(folder, feasible);
  REQUIRE(ran.status == 0);
  const json curve = json::parse(ran.out).at(0);
  CHECK(curve.at("scheme") == "intrinsic");
  REQUIRE(curve.at("segments").size() == 1);
  CHECK(curve.at("segments")[0].at("length").get<double>() == Approx(1.0447610569786732).epsilon(1e-13));
  CHECK(curve.at("counters").at("spans_not_monotone") == 0);
}

TEST_CASE("with clothoid3 two tangents alone give one clothoid, and curvatures three") {
  const ScratchFolder folder;
  const auto pieces = [&](const std::string& arguments) {
    return json::parse(run(folder, arguments + " --scheme clothoid3").out).at(0).at("segments").size();
  };
  CHECK(pieces("hermite --from 0,0,30 --to 2,1,-45") == 1);
  CHECK(pieces("hermite --from 0,0,30,1 --to 2,1,-45") == 3);
  CHECK(pieces("hermite --from 0,0,30,-1 --to 2,1,-45,0.5") == 3);
}

TEST_CASE("one curvature alone is met, with either scheme") {
  const ScratchFolder folder;
  for (const std::string scheme : {"intrinsic", "clothoid3"})
    for (const Case& data : {Case{{0, 0, 30, -0.5}, {2, 1, -45}}, Case{{0, 0, 30}, {2, 1, -45, -1.5}}}) {
      INFO(data.arguments() << " --scheme " << scheme);
      check_json(run(folder, data.arguments() + " --scheme " + scheme).out, data);
    }
}

TEST_CASE("hermite writes csv, svg and xy") {
  const ScratchFolder folder;
  for (const std::string scheme : {"intrinsic", "clothoid3"}) {
    INFO(scheme);
    const std::string verb = feasible + "--scheme " + scheme + " --format ";
    const auto csv = lines(run(folder, verb + "csv").out);
    REQUIRE(csv.size() > 2);
    CHECK(csv.front() == "curve,segment,t,x,y,s,kappa");
    CHECK(numbers(csv[1], ',').back() == Approx(0.3).epsilon(1e-12));
    CHECK(numbers(csv.back(), ',').back() == Approx(2.2).epsilon(1e-12));
    const auto xy = lines(run(folder, verb + "xy").out);
    REQUIRE(xy.size() > 2);
    CHECK(xy.front() == "# converged");
    CHECK(std::hypot(numbers(xy[1], ' ')[0], numbers(xy[1], ' ')[1]) < 1e-12);
    CHECK(std::hypot(numbers(xy.back(), ' ')[0] - 1.0, numbers(xy.back(), ' ')[1]) < 1e-12);
    CHECK(run(folder, verb + "svg -o curve.svg").out.empty());
    CHECK_THAT(contents(folder.path() / "curve.svg"), ContainsSubstring("<path d=\"M 0 0"));
    CHECK_THAT(contents(folder.path() / "curve.svg"), ContainsSubstring("</svg>"));
  }
}

TEST_CASE("data without a monotone curvature are refused by intrinsic with the reason, and met by clothoid3") {
  const ScratchFolder folder;
  write(folder.path() / "out.json", "precious");
  const Ran ran = run(folder, infeasible + "-o out.json");
  refused(ran, "from 0,0,-20,0.3 to 1,0,40,1.55: unsupported_input: ");
  CHECK_THAT(ran.err, ContainsSubstring("no monotone curvature: "));
  CHECK(ran.out.empty());
  CHECK(contents(folder.path() / "out.json") == "precious");
  const Ran arcs = run(folder, infeasible + "--scheme clothoid3");
  CHECK(arcs.status == 0);
  check_json(arcs.out, {{0, 0, -20, 0.3}, {1, 0, 40, 1.55}});
}

TEST_CASE(
    "no line comes back, and lanes do not change at a monotone curvature: the scheme that can is named, and does") {
  const ScratchFolder folder;
  for (const Case& data : {Case{{0, 0, 0, 0.0}, {-10, 0, 0, 0.0}}, Case{{0, 0, 0, 0.0}, {150, 20, 0, 0.0}},
                           Case{{3, 1, 45, 0.0}, {-7, -9, 45, 0.0}}}) {
    INFO(data.arguments());
    const Ran ran = run(folder, data.arguments());
    refused(ran, "no monotone curvature: ");
    CHECK_THAT(ran.err, ContainsSubstring("the scheme clothoid3 meets such data"));
    CHECK(ran.out.empty());
    check_json(run(folder, data.arguments() + " --scheme clothoid3").out, data);
  }
}

TEST_CASE("a circle so large that rounding decides its length is not converged, in one line") {
  const ScratchFolder folder;
  for (const std::string scheme : {"intrinsic", "clothoid3"})
    for (const std::string off : {"179.9999999", "179.999999999999"}) {
      const Ran ran = run(folder, "hermite --from 0,0," + off + " --to 10,0,-" + off + " --scheme " + scheme);
      INFO(scheme << ", " << off << ": " << ran.err);
      CHECK(ran.status == 3);
      CHECK_THAT(ran.err, ContainsSubstring("not_converged: "));
      CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
    }
}

TEST_CASE("a hermite curve that was not found is printed, marked, with exit status 3") {
  const ScratchFolder folder;
  // Clothoids from so large a curvature have rates beyond the doubles.
  const Ran ran = run(folder, "hermite --from 0,0,2,1e200 --to 1,0,0,1 --scheme clothoid3");
  CHECK(ran.status == 3);
  CHECK_THAT(ran.err, ContainsSubstring("from 0,0,2,1e200 to 1,0,0,1: not_converged: "));
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  const json curve = json::parse(ran.out).at(0);
  CHECK(curve.at("outcome") == "not_converged");
  CHECK(curve.at("segments").size() == 1);
}

TEST_CASE("directions that differ by whole turns give the same curve") {
  const ScratchFolder folder;
  for (const std::string scheme : {"intrinsic", "clothoid3"}) {
    const auto segments = [&](const std::string& from, const std::string& to) {
      const std::string ends = "hermite --from 0,0," + from + " --to 1,1," + to;
      return json::parse(run(folder, ends + " --scheme " + scheme).out).at(0).at("segments");
    };
    CHECK(segments("-30", "180") == segments("330", "-180"));
    CHECK(segments("-30", "180") == segments("-36000030", "540"));
    CHECK(segments("-30", "180") != segments("30", "180"));
  }
}

TEST_CASE("wrong arguments of hermite are one line and exit status 2") {
  const ScratchFolder folder;
  refused(run(folder, "hermite"), "--from");
  refused(run(folder, "hermite --from 0,0,0"), "--to");
  refused(run(folder, "hermite --from 0,0 --to 1,0,0"), "--from \"0,0\": 2 numbers; write x,y,DEG or x,y,DEG,kappa");
  refused(run(folder, "hermite --from 0,0,0 --to 1,0,0,1,1"), "--to \"1,0,0,1,1\": 5 numbers");
  refused(run(folder, "hermite --from '' --to 1,0,0"), "--from");
  refused(run(folder, "hermite --from 7 --to 1,0,0"), "--from \"7\": 1 number;");
  refused(run(folder, "hermite --from 0,0,east --to 1,0,0"), "DEG = \"east\" is not a number");
  refused(run(folder, "hermite --from 0,,0 --to 1,0,0"), "y = \"\" is not a number");
  refused(run(folder, "hermite --from 0,0,0 --to nan,0,0"), "x = \"nan\" is not finite");
  refused(run(folder, "hermite --from 0,0,-inf --to 1,0,0"), "DEG = \"-inf\" is not finite");
  refused(run(folder, "hermite --from 0,0,0,nan --to 1,0,0"), "kappa = \"nan\" is not finite");
  refused(run(folder, "hermite --from 0,0,0,1e999 --to 1,0,0"), "kappa = \"1e999\" does not fit a double");
  refused(run(folder, "hermite --from '0,0,0\n' --to 1,0,0"), "is not a number");
  refused(run(folder, "hermite --from 1,2,0 --to 1,2,90"), "from 1,2,0 to 1,2,90: the points coincide");
  refused(run(folder, "hermite --from 1e308,0,0 --to -1e308,0,90"), "too far apart");
  refused(run(folder, "hermite --from 0,0,0 --to 1,0,0 --scheme lambda"), "unknown scheme 'lambda'; known are");
  refused(run(folder, "hermite --from 0,0,0 --to 1,0,0 --scheme kappa"),
          "scheme 'kappa' does not take two points with tangents; those that do are clothoid3, intrinsic");
  refused(run(folder, "hermite --from 0,0,0 --to 1,0,0 --scheme intrinsic:p=2"), "p=2");
  refused(run(folder, "hermite --from 0,0,0 --to 1,0,0 --format png"), "png");
  refused(run(folder, feasible + "-o nowhere/curve.json"), "nowhere/curve.json");
  refused(run(folder, feasible + "-o /dev/full"), "/dev/full");
}

TEST_CASE("the help of hermite shows how to call it") {
  const ScratchFolder folder;
  CHECK_THAT(run(folder, "--help").out, ContainsSubstring("hermite"));
  CHECK_THAT(run(folder, "hermite --help").out, ContainsSubstring(feasible.substr(0, feasible.size() - 1)));
}
