#include "reports/store/difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/catch.hpp"
#include "tests/unit/reports/synthetic.hpp"

using namespace kappabench;
using store::Difference;

namespace {

/// The difference that a change of the synthetic results makes.
template <class Edit>
Difference after(Edit edit) {
  store::Results results = synthetic::results();
  edit(results);
  return store::difference(synthetic::results(), results);
}

long cells_of(const store::Results& results) {
  long count = 0;
  for (const store::ExperimentRecord& experiment : results.experiments)
    count += static_cast<long>(experiment.cells.size());
  return count;
}

store::CellRecord& first_cell(store::Results& results) { return results.experiments.front().cells.front(); }

std::vector<std::string> columns(const Difference& difference) {
  std::vector<std::string> names;
  for (const store::Change& change : difference.changes) names.push_back(change.column);
  return names;
}

}  // namespace

TEST_CASE("equal results differ in nothing, whatever their times and messages") {
  const Difference difference = after([](store::Results& r) {
    r.provenance["date"] = "another day";
    first_cell(r).curves.front().seconds *= 2.0;
    first_cell(r).curves.front().message = "said otherwise";
    first_cell(r).timings["fit"] = {1.0};
  });
  CHECK(difference.equal == cells_of(synthetic::results()));
  CHECK(difference.changed == 0);
  CHECK(difference.changes.empty());
  CHECK(difference.verdicts.empty());
}

TEST_CASE("a last digit, an outcome, a moved curve are changes, each in its place") {
  const Difference digit = after([](store::Results& r) {
    double& residual = first_cell(r).curves.front().residual;
    residual = std::nextafter(residual, 1.0);
  });
  CHECK(digit.changed == 1);
  CHECK(columns(digit) == std::vector<std::string>{"residual"});
  CHECK(digit.changes.front().cell.experiment == synthetic::results().experiments.front().id);
  CHECK(digit.changes.front().curve == 0);

  const Difference outcome = after([](store::Results& r) { first_cell(r).curves.front().outcome = "failed"; });
  CHECK(columns(outcome) == std::vector<std::string>{"outcome"});
  CHECK(std::get<std::string>(outcome.changes.front().after) == "failed");
  CHECK(std::isinf(store::relative_change(outcome.changes.front())));

  const Difference moved = after([](store::Results& r) { first_cell(r).curves.front().sample_x[3] += 0.25; });
  REQUIRE(columns(moved) == std::vector<std::string>{"curve moved by"});
  CHECK(std::get<double>(moved.changes.front().after) == Approx(0.25));

  const Difference measured = after([](store::Results& r) {
    store::MeasurementRecord& m = first_cell(r).curves.front().measurements.front();
    m.value = std::numeric_limits<double>::quiet_NaN();
    m.method = "enclosed";
  });
  CHECK(measured.changes.size() == 2);
}

TEST_CASE("cells of one file alone are named, and those of one name are told apart by their order") {
  const Difference fewer = after([](store::Results& r) { r.experiments.front().cells.pop_back(); });
  CHECK(fewer.only_before.size() == 1);
  CHECK(fewer.only_after.empty());
  CHECK(fewer.changed == 0);
  const Difference doubled = after([](store::Results& r) {
    std::vector<store::CellRecord>& cells = r.experiments.front().cells;
    cells.push_back(cells.front());
    cells.back().curves.front().residual = 7.0;
  });
  CHECK(doubled.only_after.size() == 1);
  CHECK(doubled.changes.empty());
}

TEST_CASE("verdicts that changed, came or went are listed") {
  const Difference difference = after([](store::Results& r) {
    REQUIRE(!r.experiments.front().claims.empty());
    r.experiments.front().claims.front().verdict = "undecided";
    r.experiments.front().claims.push_back({.paper = "another", .claim = "new", .verdict = "reproduced"});
  });
  REQUIRE(difference.verdicts.size() == 2);
  CHECK(difference.verdicts[0].before.empty() != difference.verdicts[1].before.empty());
}
