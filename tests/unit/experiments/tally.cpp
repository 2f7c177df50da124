// Tallies that count, and tables that refuse what does not fit.
#include "experiments/study/tally.hpp"

#include <cmath>
#include <stdexcept>

#include "experiments/study/table.hpp"
#include "tests/catch.hpp"

using namespace kappabench::study;

TEST_CASE("tallies count and add up") {
  Tally tally;
  tally.add(true), tally.add(false);
  tally += Tally{2, 2};
  CHECK(tally.agree == 3.0);
  CHECK(tally.misses() == 1.0);
  CHECK(tally.words() == "3 of 4 (75 %)");
  CHECK(std::isnan(Tally{}.share()));
  CHECK(all_but(1, 4).agree == 3.0);
  CHECK(one_case(false, true).cases == 0.0);
  CHECK(one_case(true, false).misses() == 1.0);
  CHECK(weaker({1, 2}, {9, 10}).cases == 2.0);
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
