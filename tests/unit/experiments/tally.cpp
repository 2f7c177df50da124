// Tallies and the verdicts that follow from them; tables that refuse what does not fit.
#include "experiments/study/tally.hpp"

#include <cmath>
#include <stdexcept>

#include "experiments/study/table.hpp"
#include "tests/catch.hpp"

using namespace kappabench::study;

TEST_CASE("verdicts follow the rule for the kind of statement") {
  CHECK(Tally{100, 100}.always() == "reproduced");
  CHECK(Tally{99, 100}.always() == "contradicted");
  CHECK(Tally{95, 100}.in_general() == "reproduced");
  CHECK(Tally{94, 100}.in_general() == "not reproduced");
  CHECK(Tally{49, 100}.in_general() == "contradicted");
  CHECK(Tally{67, 100}.often() == "reproduced");
  CHECK(Tally{60, 100}.often() == "not reproduced");
  CHECK(Tally{49, 100}.often() == "contradicted");
  // Nothing is shown by no case.
  for (const std::string& verdict : {Tally{}.always(), Tally{}.in_general(), Tally{}.often()})
    CHECK(verdict == "not reproduced");
  CHECK(std::isnan(Tally{}.share()));
}

TEST_CASE("tallies count and add up") {
  Tally tally;
  tally.add(true), tally.add(false);
  tally += Tally{2, 2};
  CHECK(tally.agree == 3.0);
  CHECK(tally.misses() == 1.0);
  CHECK(tally.words() == "3 of 4 (75 %)");
}

TEST_CASE("a row of a table has a value of the right kind for every column") {
  Table table("t", "T", "");
  table.words("name").numbers("value", "1/length").counts("n");
  table.row({"a", 0.5, 3});
  CHECK_THROWS_AS(table.row({"a", 0.5}), std::logic_error);
  CHECK_THROWS_AS(table.row({0.5, "a", 3}), std::logic_error);
  CHECK(table.record().columns[2].whole_numbers);
  CHECK(std::get<std::vector<double>>(table.record().columns[1].cells).size() == 1);
}
