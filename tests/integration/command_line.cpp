// The program as scripts call it: exit status, one line on stderr, formats.
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "schemes/curve/vec.hpp"
#include "tests/catch.hpp"
#include "tests/integration/program.hpp"

using kappabench::ScratchFolder;
using kappabench::Vec2;
using namespace kappabench::test;
using nlohmann::json;

namespace {

const std::string five = "closed\n0 0\n4 -1\n5 3\n2 5\n-1 3\n";

Vec2 point(const json& p) { return {p[0].get<double>(), p[1].get<double>()}; }

}  // namespace

TEST_CASE("fit prints the curve as kappabench-curve JSON that rebuilds it") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  const Ran ran = run(folder, "fit five.txt --scheme ekappa:a=0.8");
  REQUIRE(ran.status == 0);
  CHECK(ran.err.empty());
  const json curve = json::parse(ran.out).at(0);
  CHECK(curve["format"] == "kappabench-curve");
  CHECK(curve["version"] == 2);
  CHECK(curve["scheme"] == "ekappa");
  CHECK(curve["parameters"]["a"] == 0.8);
  CHECK(curve["closed"] == true);
  CHECK(curve["outcome"] == "converged");
  CHECK(curve["residual"].get<double>() <= 1e-12);
  CHECK(curve["counters"]["at_inflection"] == 0);
  CHECK(curve["counters"]["newton"].get<int>() + curve["counters"]["sweeps"].get<int>() > 0);
  REQUIRE(curve["segments"].size() == 5);
  REQUIRE(curve["nodes"].size() == 5);
  REQUIRE(curve["joints"].size() == 5);
  // The control points alone give the input point at the node: Bernstein's cubic by hand.
  const json& node = curve["nodes"][1];
  const json& c = curve["segments"][node["segment"].get<std::size_t>()]["control_points"];
  REQUIRE(c.size() == 4);
  const double t = node["t"].get<double>(), u = 1.0 - t;
  const Vec2 at =
      u * u * u * point(c[0]) + 3 * u * u * t * point(c[1]) + 3 * u * t * t * point(c[2]) + t * t * t * point(c[3]);
  CHECK((at - Vec2(4, -1)).norm() < 1e-12);
  CHECK_THAT(ran.out, ContainsSubstring(R"("a":0.8,)"));  // the shortest digits that read back
  CHECK(curve["version"].is_number_integer());
  CHECK(node["point"].is_number_integer());
  CHECK(node["marks"] == json::array());
}

TEST_CASE("the trigonometric scheme names the nodes where |curvature| has a minimum") {
  const ScratchFolder folder;
  // An octagon turns by 45 degrees a point, less than the 58 degrees where a = 0.55 begins to have maxima.
  write(folder.path() / "octagon.txt", "closed\n2 0\n1.4 1.4\n0 2\n-1.4 1.4\n-2 0\n-1.4 -1.4\n0 -2\n1.4 -1.4\n");
  const json curve = json::parse(run(folder, "fit octagon.txt --scheme ekappa-trig:a=0.55").out).at(0);
  REQUIRE(curve["nodes"].size() == 8);
  for (const json& node : curve["nodes"]) CHECK(node["marks"] == json::array({"curvature_minimum"}));
  const json sharp = json::parse(run(folder, "fit octagon.txt --scheme ekappa-trig:a=0.8").out).at(0);
  for (const json& node : sharp["nodes"]) CHECK(node["marks"] == json::array());
}

TEST_CASE("a drawing of several curves is a JSON array, and '-' is standard input") {
  const ScratchFolder folder;
  write(folder.path() / "two.txt", five + "\nopen\n0 0\n1 1\n2 0\n");
  CHECK(json::parse(run(folder, "fit - --scheme kappa < two.txt").out).size() == 2);
}

TEST_CASE("fit writes csv, svg and xy") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  CHECK(run(folder, "fit five.txt --scheme kappa --format csv").out.starts_with("curve,segment,t,x,y,s,kappa\n"));
  CHECK_THAT(run(folder, "fit five.txt --scheme kappa --format svg").out, ContainsSubstring("</svg>"));
  CHECK_THAT(run(folder, "fit five.txt --scheme ekappa-trig --format xy").out, ContainsSubstring("# converged"));
  CHECK(run(folder, "fit five.txt --scheme kappa --format svg -o five.svg").out.empty());
  CHECK_THAT(contents(folder.path() / "five.svg"), ContainsSubstring("<path d=\"M "));
}

TEST_CASE("wrong arguments and bad input are one line and exit status 2") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  write(folder.path() / "nan.txt", "closed\n0 0\n1 nan\n2 0\n");
  write(folder.path() / "inf.txt", "0 0\n1 inf\n2 0\n");
  write(folder.path() / "one.txt", "0 0\n");
  write(folder.path() / "twins.txt", "0 0\n1 1\n1 1\n2 0\n");
  write(folder.path() / "key.txt", "0 0 b=3\n1 1\n2 0\n");
  write(folder.path() / "sharp.txt", "0 0\n1 1 a=1.5\n2 0\n");
  write(folder.path() / "rubbish.txt", std::string("\x7f"
                                                   "ELF\0\1\2\xff\xfe",
                                                   9));
  write(folder.path() / "empty.txt", "");
  refused(run(folder, ""), "subcommand");
  refused(run(folder, "draw five.txt"), "draw");
  refused(run(folder, "fit five.txt"), "--scheme");
  refused(run(folder, "fit five.txt --scheme lambda"), "unknown scheme 'lambda'; known are");
  refused(run(folder, "fit five.txt --scheme kappa:b=1"), "unknown parameter 'b'");
  refused(run(folder, "fit five.txt --scheme ekappa:a=1"), "a=1: allowed is a number in [0.6667, 1)");
  refused(run(folder, "fit five.txt --scheme kappa --format png"), "png");
  refused(run(folder, "fit nowhere.txt --scheme kappa"), "nowhere.txt");
  refused(run(folder, "fit nan.txt --scheme kappa"), "nan.txt:3");
  refused(run(folder, "fit inf.txt --scheme kappa"), "inf.txt:2");
  refused(run(folder, "fit one.txt --scheme kappa"), "one.txt");
  refused(run(folder, "fit twins.txt --scheme kappa"), "points 1 and 2 coincide");
  refused(run(folder, "fit key.txt --scheme kappa"), "key.txt:1");
  refused(run(folder, "fit sharp.txt --scheme ekappa"), "a=1.5");
  refused(run(folder, "fit rubbish.txt --scheme kappa"), "rubbish.txt");
  refused(run(folder, "fit empty.txt --scheme kappa"), "empty.txt");
  refused(run(folder, "fit five.txt --scheme kappa -o nowhere/five.json"), "nowhere/five.json");
  refused(run(folder, "fit five.txt --scheme kappa -o /dev/full"), "/dev/full");
  refused(run(folder, "run nonsense"), "unknown experiment 'nonsense'; known are");
  refused(run(folder, "report five.txt -o report"), "five.txt");
  refused(run(folder, "compare five.txt --metrics beauty"), "unknown metric 'beauty'");
  refused(run(folder, "list things"), "things");
  refused(run(folder, "check"), "give one scheme, ID[:key=value,...], or --all");
  refused(run(folder, "check kappa --all"), "give one scheme");
  refused(run(folder, "check lambda"), "unknown scheme 'lambda'; known are");
  refused(run(folder, "check ekappa:a=1"), "a=1: allowed is a number in [0.6667, 1)");
  refused(run(folder, "check catmull-rom -o nowhere/page.txt"), "nowhere/page.txt");
}

TEST_CASE("what was there before is kept when a fit fails") {
  const ScratchFolder folder;
  write(folder.path() / "one.txt", "0 0\n");
  write(folder.path() / "out.json", "precious");
  CHECK(run(folder, "fit one.txt --scheme kappa -o out.json").status == 2);
  CHECK(contents(folder.path() / "out.json") == "precious");
}

TEST_CASE("a fit that did not converge prints its curve, marked, with exit status 3") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  const Ran ran = run(folder, "fit five.txt --scheme kappa:iteration=published,max_iterations=1");
  CHECK(ran.status == 3);
  CHECK_THAT(ran.err, ContainsSubstring("not_converged"));
  const json curve = json::parse(ran.out).at(0);
  CHECK(curve["outcome"] == "not_converged");
  CHECK(curve["segments"].size() == 5);
}

TEST_CASE("list schemes --json says which marks a scheme may set on a node, and which libraries it needs") {
  const ScratchFolder folder;
  std::map<std::string, json> schemes;
  for (const json& scheme : json::parse(run(folder, "list schemes --json").out)) schemes[scheme["id"]] = scheme;
  std::vector<std::string> marks;
  for (const json& mark : schemes.at("ekappa-trig").at("marks")) {
    marks.push_back(mark.at("name"));
    CHECK_FALSE(mark.at("help").get<std::string>().empty());
  }
  CHECK(marks == std::vector<std::string>{"pinned", "at_inflection", "curvature_minimum"});
  CHECK(schemes.at("catmull-rom").at("marks") == json::array());
  CHECK(schemes.at("pkappa").at("libraries").contains("ceres"));
}

TEST_CASE("check prints a table of claims, or JSON, and says by its status whether one is refuted") {
  const ScratchFolder folder;
  const Ran page = run(folder, "check catmull-rom");
  CHECK(page.err.empty());
  CHECK(page.out.starts_with("catmull-rom: Cubic Catmull-Rom spline\n"));
  const Ran quiet = run(folder, "check catmull-rom:alpha=0 --json -o page.json");
  CHECK(quiet.out.empty());
  const json all = json::parse(contents(folder.path() / "page.json"));
  REQUIRE(all.size() == 1);
  CHECK(all[0]["scheme"] == "catmull-rom:alpha=0");
  std::map<std::string, std::string> verdicts;
  for (const json& claim : all[0]["claims"]) verdicts[claim["claim"]] = claim["verdict"];
  CHECK(verdicts.at("interpolation") == "held");
  CHECK(verdicts.at("hermite") == "not claimed");
  bool refuted = false;
  for (const auto& entry : verdicts) refuted = refuted || entry.second == "refuted";
  CHECK(all[0]["sound"] == !refuted);
  CHECK(quiet.status == (refuted ? 3 : 0));
  // A claim that its own parameters make false: one sweep does not solve anything.
  const Ran lazy = run(folder, "check kappa:iteration=published,max_iterations=1");
  CHECK(lazy.status == 3);
  CHECK_THAT(lazy.out, ContainsSubstring("solves is refuted"));
  CHECK_THAT(lazy.out, ContainsSubstring("$ kappabench fit random:star:n=5"));
}

TEST_CASE("list names schemes, datasets, metrics and experiments") {
  const ScratchFolder folder;
  for (const std::string what : {"schemes", "datasets", "metrics", "experiments"}) {
    CHECK(run(folder, "list " + what).status == 0);
    const json items = json::parse(run(folder, "list " + what + " --json").out);
    CHECK(items.size() >= 1);
    CHECK(items[0].contains("id"));
  }
}

TEST_CASE("a results file is a yardstick: its schemes stand beside, and are not computed again") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  REQUIRE(run(folder, "compare five.txt --schemes kappa,hobby -o published").status == 0);
  const Ran ran =
      run(folder, "compare five.txt --schemes catmull-rom --against published/results.h5 --format json -o mine");
  REQUIRE(ran.status == 0);
  std::map<std::string, json> rows;
  for (const json& row : json::parse(ran.out)) rows[row["scheme"]] = row;
  REQUIRE(rows.size() == 3);
  CHECK(rows.contains("catmull-rom"));
  const json published = json::parse(run(folder, "compare five.txt --schemes kappa,hobby --format json").out);
  for (const json& row : published) {
    json beside = rows.at(row["scheme"].get<std::string>() + " [results.h5]");
    beside["scheme"] = row["scheme"];
    CHECK(beside == row);
  }
  CHECK_THAT(contents(folder.path() / "mine" / "index.html"), ContainsSubstring("hobby [results.h5]"));
  refused(run(folder, "compare toy --schemes kappa --against published/results.h5"), "points of toy");
  refused(run(folder, "compare five.txt --against published/results.h5"), "--schemes");
  refused(run(folder, "compare five.txt --schemes kappa --against nowhere.h5"), "nowhere.h5");
}

TEST_CASE("diff says what changed from one results file to another") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  REQUIRE(run(folder, "compare five.txt --schemes kappa,hobby -o one").status == 0);
  REQUIRE(run(folder, "compare five.txt --schemes kappa,hobby -o same").status == 0);
  CHECK_THAT(run(folder, "diff one/results.h5 same/results.h5").out,
             ContainsSubstring("2 cells are in both files and equal, 0 changed"));
  write(folder.path() / "five.txt", "closed\n0 0\n4 -1\n5 3.5\n2 5\n-1 3\n");
  REQUIRE(run(folder, "compare five.txt --schemes kappa,cubic-spline -o other").status == 0);
  const Ran ran = run(folder, "diff one/results.h5 other/results.h5");
  CHECK(ran.status == 0);
  CHECK_THAT(ran.out, ContainsSubstring("0 cells are in both files and equal, 1 changed"));
  CHECK_THAT(ran.out, ContainsSubstring("only in one/results.h5: compare, five, hobby"));
  CHECK_THAT(ran.out, ContainsSubstring("curve moved by"));
  const json changes = json::parse(run(folder, "diff one/results.h5 other/results.h5 --format json").out);
  CHECK(changes.size() > 10);
  for (const json& change : changes) CHECK(change["scheme"] == "kappa");
  refused(run(folder, "diff one/results.h5 five.txt"), "five.txt");
}

TEST_CASE("compare prints a table in every format, and keeps a report where asked") {
  const ScratchFolder folder;
  write(folder.path() / "five.txt", five);
  const std::string what = "compare five.txt --schemes kappa,ekappa:a=0.9,iteration=newton,catmull-rom ";
  const json rows = json::parse(run(folder, what + "--format json").out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["scheme"] == "kappa");
  CHECK(rows[1]["scheme"] == "ekappa a=0.9");
  CHECK(rows[2]["outcome"] == "converged");
  CHECK(run(folder, what + "--format csv").out.starts_with("dataset,curve,scheme"));
  CHECK_THAT(run(folder, what + "--format latex").out, ContainsSubstring("\\begin{tabular}"));
  CHECK_THAT(run(folder, what).out, ContainsSubstring("catmull-rom"));
  CHECK(run(folder, what + "-o report").status == 0);
  CHECK(std::filesystem::exists(folder.path() / "report" / "index.html"));
  CHECK(std::filesystem::exists(folder.path() / "report" / "results.h5"));
}

TEST_CASE("drawings of the same name are told apart") {
  const ScratchFolder folder;
  for (const std::string place : {"a", "b"}) {
    std::filesystem::create_directory(folder.path() / place);
    write(folder.path() / place / "five.txt", five);
  }
  const Ran ran = run(folder, "compare a b --schemes catmull-rom --format json");
  REQUIRE(ran.status == 0);
  const json rows = json::parse(ran.out);
  CHECK(rows[0]["dataset"] == "five");
  CHECK(rows[1]["dataset"] == "five-2");
}
