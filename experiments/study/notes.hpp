#pragma once

#include <vector>

#include "experiments/study/quantity.hpp"
#include "reports/store/model.hpp"

namespace kappabench::study {

/// Where a measurement puts its numbers: rows of a cell, each told apart by its keys.
class Notes {
 public:
  explicit Notes(store::CellRecord& cell) : cell_(&cell) {}

  /// A row: "at this joint of the curve with this a, these numbers". Rows with the same columns make a table of the
  /// results file.
  void row(const std::vector<KeyIs>& keys, const std::vector<Reading>& readings);
  /// A row of a single number that the cell's drawing and label are keys enough for.
  void put(const Reading& reading) { row({}, {reading}); }

  /// The cell itself, for timings, outcome and drawn curves.
  [[nodiscard]] store::CellRecord& cell() const { return *cell_; }

 private:
  store::CellRecord* cell_;
};

}  // namespace kappabench::study
