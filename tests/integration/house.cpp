// The start errors: what the compiler cannot see of the lists that the house is made of.

#include "experiments/run/house.hpp"

#include <vector>

#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;

namespace {

const std::vector<Paper> papers{
    {"loops-2000-roe", "Loops", "R. Roe", {{"round", "Fig. 1", "They are round.", ""}}, {}}};

Experiment experiment(std::string id, std::string paper, std::vector<std::string> claims) {
  return {.id = std::move(id),
          .title = "",
          .about = "",
          .paper = std::move(paper),
          .claims = std::move(claims),
          .jobs = nullptr,
          .conclude = [](const Context&, store::ExperimentRecord& record) {
            record.claims.push_back({.paper = "loops-2000-roe", .claim = "round"});
          }};
}

void check(std::vector<Experiment> experiments, const std::vector<Drawing>& drawings = {}) {
  check_house(experiments, papers, drawings);
}

}  // namespace

TEST_CASE("a sound house passes") {
  CHECK_NOTHROW(check({experiment("a", "loops-2000-roe", {"round"}), experiment("b", "", {})}));
}

TEST_CASE("two experiments with one id are a start error") {
  CHECK_THROWS_WITH(check({experiment("a", "", {}), experiment("a", "", {})}), "two experiments have the id 'a'");
}

TEST_CASE("a declared claim that its paper's file lacks is a start error, and so is a paper without a file") {
  CHECK_THROWS_WITH(check({experiment("a", "loops-2000-roe", {"square"})}),
                    "experiment a: reports/paper/loops-2000-roe.toml has no claim 'square'; add it there");
  CHECK_THROWS_WITH(check({experiment("a", "loops-1999-doe", {})}),
                    "experiment a: there is no reports/paper/loops-1999-doe.toml");
  CHECK_THROWS_WITH(check({experiment("a", "", {"round"})}),
                    "experiment a: judges the claim 'round' of no paper; name the paper");
}

TEST_CASE("drawings with one id and drawings without metadata are start errors") {
  const Drawing drawing{.id = "d", .title = "D", .source = "S", .licence = "CC0", .units = "mm"};
  CHECK_NOTHROW(check({}, {drawing}));
  CHECK_THROWS_WITH(check({}, {drawing, drawing}), "two built-in drawings have the id 'd'");
  CHECK_THROWS_WITH(check({}, {{.id = "d", .title = "D", .source = "S", .licence = "CC0"}}),
                    "datasets/points/d.txt: no units; begin with a line '# units: ...'");
}

TEST_CASE("a verdict on a claim that was not declared is an error, with a paper or without") {
  const Context context{.registry = test::all_schemes()};
  store::ExperimentRecord record;
  CHECK_THROWS_WITH(
      conclude(experiment("b", "", {}), context, record),
      "experiment b: judges the claim 'round' of loops-2000-roe, which it does not declare; add it to its "
      "claims");
  record.claims.clear();
  CHECK_NOTHROW(conclude(experiment("a", "loops-2000-roe", {"round"}), context, record));
  CHECK_THROWS_WITH(
      conclude(experiment("a", "loops-2000-roe", {}), context, record),
      "experiment a: judges the claim 'round' of loops-2000-roe, which it does not declare; add it to its "
      "claims");
}
