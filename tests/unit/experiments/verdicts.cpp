// One rule for each kind of statement; an interval on both sides of a bound decides nothing.
#include "experiments/study/verdicts.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace kappabench;
using namespace kappabench::study;

namespace {

std::string of(StatementKind kind, double agree, double cases) { return ruling(kind, Tally{agree, cases}).verdict; }

std::string measured(StatementKind kind, const Interval& interval) {
  const PrintedClaim claim{
      .id = "c", .place = "", .text = "", .printed = "", .kind = kind, .at_least = 1.0, .at_most = 2.0};
  return ruling(claim, interval).verdict;
}

}  // namespace

TEST_CASE("Wilson's interval") {
  // Newcombe, Two-sided confidence intervals for the single proportion, Stat. Med. 17 (1998), Table I, method 3.
  const Interval i = wilson({81, 263});
  CHECK(i.low == Approx(0.2553).margin(5e-5));
  CHECK(i.high == Approx(0.3662).margin(5e-5));
  CHECK(wilson({0, 20}).low == 0.0);
  CHECK(wilson({0, 20}).high == Approx(0.1611).margin(5e-5));
  CHECK(wilson({20, 20}).high == 1.0);
  CHECK(wilson({}).low == 0.0);
  CHECK(wilson({}).high == 1.0);
}

TEST_CASE("the interval of a median holds the median") {
  std::vector<double> numbers(101);
  std::iota(numbers.begin(), numbers.end(), 0.0);
  const Interval i = interval_of_median(numbers);
  CHECK(i.low > 35.0);
  CHECK(i.low < 45.0);
  CHECK(i.high > 55.0);
  CHECK(i.high < 65.0);
  CHECK(std::isnan(interval_of_median({}).low));
}

TEST_CASE("always: a counterexample decides") {
  CHECK(of(StatementKind::always, 100, 100) == "reproduced");
  CHECK(of(StatementKind::always, 99, 100) == "contradicted");
}

TEST_CASE("in general and often: what the sample says of all cases decides") {
  using enum StatementKind;
  CHECK(of(in_general, 200, 200) == "reproduced");
  CHECK(of(in_general, 20, 20) == "undecided");  // 84 % or more of all
  CHECK(of(in_general, 970, 1000) == "reproduced");
  CHECK(of(in_general, 960, 1000) == "undecided");
  CHECK(of(in_general, 900, 1000) == "not reproduced");
  CHECK(of(in_general, 500, 1000) == "not reproduced");
  CHECK(of(in_general, 400, 1000) == "contradicted");
  CHECK(of(often, 700, 1000) == "reproduced");
  CHECK(of(often, 680, 1000) == "undecided");
  CHECK(of(often, 600, 1000) == "not reproduced");
  CHECK(of(often, 400, 1000) == "contradicted");
}

TEST_CASE("may: one case is enough, and many without one are") {
  CHECK(of(StatementKind::may, 1, 1000) == "reproduced");
  CHECK(of(StatementKind::may, 0, 200) == "not reproduced");
  CHECK(of(StatementKind::may, 0, 199) == "undecided");
}

TEST_CASE("nothing is shown by no case") {
  using enum StatementKind;
  for (const StatementKind kind : {always, in_general, often, may}) CHECK(of(kind, 0, 0) == "undecided");
  CHECK(measured(growth, interval_of_median({})) == "undecided");
}

TEST_CASE("growth and numbers are held against the bounds of the paper's file") {
  using enum StatementKind;
  CHECK(measured(growth, {1.0, 2.0}) == "reproduced");
  CHECK(measured(growth, {0.5, 1.5}) == "undecided");
  CHECK(measured(growth, {2.1, 3.0}) == "contradicted");
  CHECK(measured(StatementKind::number, {0.5, 0.9}) == "not reproduced");
  CHECK_THROWS_AS(measured(often, {1.0, 1.0}), std::logic_error);
  CHECK_THROWS_AS(of(growth, 1, 1), std::logic_error);
}

TEST_CASE("a misprint fails as printed and holds corrected") {
  CHECK(ruling_on_formula({0, 5}, {5, 5}).verdict == "misprint");
  CHECK(ruling_on_formula({5, 5}, {5, 5}).verdict == "reproduced");
  CHECK(ruling_on_formula({0, 5}, {4, 5}).verdict == "contradicted");
  CHECK(ruling_on_formula({}, {}).verdict == "undecided");
}
