// Rows: what a measurement puts is what conclusions read, by key.
#include "experiments/study/rows.hpp"

#include <cmath>

#include "experiments/program/scratch_folder.hpp"
#include "experiments/study/notes.hpp"
#include "reports/store/hdf5_store.hpp"
#include "tests/catch.hpp"

using namespace kappabench;
using namespace kappabench::study;

namespace {

const Key joint{"joint"}, shape{"a"};
const Quantity gap{"gap", "1/length", Method::sampled}, seen = count_of("seen");

/// Two drawings, three joints, two values of a; joint 2 of the fish has no gap at a = 0.8.
std::vector<store::CellRecord> cells() {
  std::vector<store::CellRecord> found;
  for (const std::string dataset : {"bird", "fish"}) {
    store::CellRecord cell;
    cell.dataset = dataset;
    cell.label = "gaps (numbers)";
    Notes notes(cell);
    for (int j = 0; j < 3; ++j)
      for (const auto& [word, factor] : {std::pair("0.7", 1.0), std::pair("0.8", 0.5)}) {
        if (dataset == "fish" && j == 2 && factor < 1.0) continue;
        notes.row({joint(j), shape(word)}, {gap(factor * (j + 1)), seen(1)});
      }
    notes.put(gap(100.0));
    found.push_back(cell);
  }
  return found;
}

}  // namespace

TEST_CASE("rows are selected, grouped and summed by their keys") {
  const Rows rows(cells());
  CHECK(rows.size() == 13);
  CHECK(rows.total(seen) == 11.0);
  CHECK(rows.where({shape("0.7")}).values(gap) == std::vector{1.0, 2.0, 3.0, 1.0, 2.0, 3.0});
  CHECK(rows.where({key::dataset("fish"), shape("0.8")}).total(gap) == 1.5);
  CHECK(rows.where({key::dataset("fish"), joint(2)}).size() == 1);
  CHECK(rows.where({shape("0.9")}).empty());
  CHECK(std::isnan(rows.where({shape("0.9")}).median(gap)));
  CHECK(rows.words_of(key::dataset) == std::vector<std::string>{"bird", "fish"});
  const auto by_joint = rows.by(joint);
  REQUIRE(by_joint.size() == 3);
  CHECK(by_joint[1].first == KeyValue(1.0));
  CHECK(by_joint[1].second.mean(gap) == 1.5);
}

TEST_CASE("pairs meet by all other keys, and rows without a partner are left out") {
  const Rows rows(cells());
  const std::vector<Pair> pairs = rows.pairs(gap, shape("0.7"), shape("0.8"));
  REQUIRE(pairs.size() == 5);
  for (const auto& [first, second] : pairs) CHECK(second == 0.5 * first);
  CHECK(rows.pairs(gap, shape("0.7"), shape("0.9")).empty());
  CHECK(rows.pairs(gap, key::dataset("bird"), key::dataset("fish")).size() == 6);
}

TEST_CASE("a number stands with its unit and its method in the file, and comes back") {
  const ScratchFolder folder;
  const store::CellRecord cell = cells().front();
  store::write_cell(folder.path() / "cell.h5", cell);
  const store::CellRecord read = store::read_cell(folder.path() / "cell.h5");
  CHECK(read.rows == cell.rows);
  REQUIRE(read.rows.size() == 2);
  const store::TableColumn& column = read.rows.front().columns[2];
  CHECK(column.name == "gap");
  CHECK(column.unit == "1/length");
  CHECK(column.method == "sampled");
  CHECK(read.rows.front().columns[0].method.empty());
}

TEST_CASE("a column that a row lacks is an error, not a zero") {
  const Rows rows(cells());
  const Quantity other{"other", "1", Method::exact};
  CHECK_THROWS_AS((**rows.begin())[other], std::out_of_range);
  CHECK(rows.values(other).empty());
}
