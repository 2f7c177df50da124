// Curves that were made elsewhere, measured as scripts do it: what a fit wrote is read back and measured as the fit
// was, in the same tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "datasets/datasets.hpp"
#include "experiments/study/given_job.hpp"
#include "tests/catch.hpp"
#include "tests/integration/program.hpp"

using namespace kappabench;
using namespace kappabench::test;
using nlohmann::json;

namespace {

json rows_of(const Ran& ran) {
  INFO(ran.err);
  REQUIRE(ran.status == 0);
  return json::parse(ran.out);
}

/// Of a row of `fitted`, as far as `measured` has the same: the scheme's name is the file's.
void check_equal(const json& measured, const json& fitted) {
  REQUIRE(measured.size() == fitted.size());
  for (const auto& [name, value] : fitted.items()) {
    CAPTURE(name);
    if (name != "scheme") CHECK(measured.at(name) == value);
  }
}

/// Numbers to the accuracy that rounding of the curve leaves them, which is that of their own size or of one.
void check_close(const json& measured, const json& fitted, double accuracy) {
  REQUIRE(measured.size() == fitted.size());
  for (const auto& [name, value] : fitted.items()) {
    if (name == "scheme") continue;
    CAPTURE(name, value, measured.at(name));
    if (!value.is_number()) {
      CHECK(measured.at(name) == value);
      continue;
    }
    REQUIRE(measured.at(name).is_number());
    const double a = value.get<double>(), b = measured.at(name).get<double>();
    CHECK(std::abs(a - b) <= accuracy * std::max(1.0, std::abs(a)));
  }
}

}  // namespace

TEST_CASE("measure: curve JSON of any scheme gives the numbers of compare, to the last bit", "[measure]") {
  const ScratchFolder folder;
  const std::vector<std::string> schemes{"kappa",  "ekappa",    "ekappa-trig",  "fpc",
                                         "pkappa", "yuksel",    "cubic-spline", "catmull-rom",
                                         "hobby",  "clothoid3", "intrinsic",    "euler-spiral"};
  for (const std::string& scheme : schemes) {
    CAPTURE(scheme);
    const json compared = rows_of(run(folder, "compare bird --format json --schemes " + scheme));
    REQUIRE(compared.size() == 1);
    if (compared[0].at("outcome") != "converged") continue;
    REQUIRE(run(folder, "fit bird --scheme " + scheme + " -o fitted.json").status == 0);
    const json measured = rows_of(run(folder, "measure fitted.json --points bird --format json"));
    REQUIRE(measured.size() == 1);
    CHECK(measured[0].at("scheme") == "fitted.json");
    check_equal(measured[0], compared[0]);
  }
}

TEST_CASE("measure: SVG of polynomial schemes gives the numbers of compare, to rounding", "[measure]") {
  const ScratchFolder folder;
  for (const std::string scheme : {"kappa", "cubic-spline", "catmull-rom", "hobby"})
    for (const std::string points : {"bird", "s-curve"}) {
      CAPTURE(scheme, points);
      const Ran fit = run(folder, "fit " + points + " --scheme " + scheme + " --format svg -o fitted.svg");
      if (fit.status != 0) continue;  // kappa takes no open curve
      const json compared = rows_of(run(folder, "compare " + points + " --format json --schemes " + scheme));
      const json measured = rows_of(run(folder, "measure fitted.svg --points " + points + " --format json"));
      REQUIRE(measured.size() == 1);
      json expected = compared[0];
      // A path does not say how it was found.
      for (const char* unknown : {"iterations", "pinned", "at_inflection"}) expected[unknown] = 0;
      expected["residual"] = 0.0;
      check_close(measured[0], expected, 1e-9);
    }
}

TEST_CASE("compare --curves: a row beside the fits, equal to that of measure", "[measure]") {
  const ScratchFolder folder;
  REQUIRE(run(folder, "fit bird --scheme hobby -o mine.svg").status == 0);
  REQUIRE(run(folder, "fit bird --scheme cubic-spline -o other.json").status == 0);
  const json rows =
      rows_of(run(folder, "compare bird --schemes kappa,hobby --curves mine.svg,other.json --format json -o page"));
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].at("scheme") == "kappa");
  CHECK(rows[2].at("scheme") == "mine.svg");
  CHECK(rows[3].at("scheme") == "other.json");
  check_close(rows[2].at("mvc_energy"), rows[1].at("mvc_energy"), 1e-9);
  const json measured = rows_of(run(folder, "measure mine.svg other.json --points bird --format json"));
  REQUIRE(measured.size() == 2);
  CHECK(measured[0] == rows[2]);
  CHECK(measured[1] == rows[3]);

  const std::string page = contents(folder.path() / "page" / "index.html");
  CHECK_THAT(page, ContainsSubstring("mine.svg"));
  CHECK_THAT(page, ContainsSubstring("distance from each point"));
  // Without schemes all of them, and a name that is taken.
  write(folder.path() / "kappa", contents(folder.path() / "mine.svg"));
  const Ran all = run(folder, "compare bird --curves kappa --metrics fairness --format csv");
  CHECK(all.status == 0);
  CHECK_THAT(all.out, ContainsSubstring("bird,0,kappa-2,"));
  CHECK_THAT(all.out, ContainsSubstring("bird,0,pkappa,"));
}

TEST_CASE("measure: a circle at its own vertices, in every format", "[measure]") {
  const ScratchFolder folder;
  write(folder.path() / "circle.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>\n"
        "<g transform='rotate(30)'><circle cx='4' cy='4' r='2'/></g></svg>\n");
  const json row = rows_of(run(folder, "measure circle.svg --format json")).at(0);
  CHECK(row.at("dataset") == "circle");
  CHECK(row.at("points") == 4);
  CHECK(row.at("outcome") == "converged");
  CHECK(row.at("curvature_extrema") == 0);
  CHECK(row.at("mvc_energy").get<double>() == Approx(0.0).margin(1e-9));
  CHECK(row.at("continuity_curvature_jump_all").get<double>() < 1e-12);
  const std::pair<const char*, const char*> formats[] = {
      {"table", "circle.svg"}, {"csv", "circle,0,circle.svg,4,converged"}, {"latex", "circle.svg"}};
  for (const auto& [format, what] : formats)
    CHECK_THAT(run(folder, std::string("measure circle.svg --format ") + format).out, ContainsSubstring(what));
  const Ran paged = run(folder, "measure circle.svg -o page");
  CHECK(paged.status == 0);
  CHECK_THAT(contents(folder.path() / "page" / "index.html"), ContainsSubstring("circle.svg"));
  CHECK(std::filesystem::exists(folder.path() / "page" / "results.h5"));
}

TEST_CASE("measure: a curve that misses its points is said so and measured", "[measure]") {
  const ScratchFolder folder;
  write(folder.path() / "line.svg", "<svg><path d='M0 0H4'/></svg>");
  write(folder.path() / "points.txt", "0 0\n2 0.5\n4 0\n");
  const Ran ran = run(folder, "measure line.svg --points points.txt --format json");
  const json row = rows_of(ran).at(0);
  CHECK(row.at("outcome") == "not_converged");
  CHECK(row.at("residual").get<double>() == Approx(0.5 / std::hypot(2.0, 0.5)).epsilon(1e-12));
  CHECK(row.at("curvature_extrema") == 0);
  CHECK_THAT(ran.err, ContainsSubstring("line.svg: not_converged: misses its claim: the curve passes point 1 at"));
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
}

TEST_CASE("measure: what cannot be measured is refused in one line", "[measure]") {
  const ScratchFolder folder;
  write(folder.path() / "bad.svg", "<svg>\n<path d='M0 0\nL1'/></svg>");
  write(folder.path() / "points.txt", "0 0\n1 1\n2 0\n");
  write(folder.path() / "line.svg", "<svg><path d='M0 0H4'/></svg>");
  write(folder.path() / "failed.json", R"({"outcome":"failed","message":"no","segments":[]})");
  refused(run(folder, "measure bad.svg"), "bad.svg:3: the end where y is needed");
  refused(run(folder, "measure nobody.svg"), "nobody.svg: cannot be opened");
  refused(run(folder, "measure points.txt"), "points.txt:1: neither curve JSON nor SVG");
  refused(run(folder, "measure line.svg --metrics locality"), "metric locality fits again");
  refused(run(folder, "measure line.svg --metrics nonsense"), "nonsense");
  refused(run(folder, "measure line.svg --points nonsense"), "nonsense");
  refused(run(folder, "measure failed.json"), "failed.json: no curve with segments");
  refused(run(folder, "compare bird --schemes kappa --curves bad.svg"), "bad.svg:3:");
}

TEST_CASE("the key of a measured curve is that of the file's content", "[measure]") {
  const ScratchFolder folder;
  const std::vector<Drawing> bird = open_drawings("bird");
  const auto key = [&](const std::string& data) {
    write(folder.path() / "a.svg", "<svg><path d='" + data + "'/></svg>");
    const auto given = std::make_shared<const GivenCurves>("a.svg", read_curve_file(folder.path() / "a.svg"));
    return study::measure_job(bird.front(), given, {}).key();
  };
  CHECK(key("M0 0H1") == key("M0 0H1"));
  CHECK(key("M0 0H1") != key("M0 0H2"));
}
