#pragma once

#include <string>
#include <variant>
#include <vector>

#include "reports/store/model.hpp"

namespace kappabench::store {

/// Which cell: cells of two files are the same if experiment, drawing and label are, and if there are several such, in
/// the order of the file.
struct CellName {
  std::string experiment, dataset, label;
  bool operator==(const CellName&) const = default;
  auto operator<=>(const CellName&) const = default;
};

/// A number or a word that two files disagree on.
struct Change {
  CellName cell;
  int curve;  ///< of the drawing; -1: of the cell itself
  std::string column;
  std::variant<double, std::string> before, after;
};

struct VerdictChange {
  std::string paper, claim, before, after;  ///< "" where a file does not judge it
};

struct Difference {
  long equal = 0;    ///< cells in both files without a change
  long changed = 0;  ///< cells in both files with one
  std::vector<CellName> only_before, only_after;
  std::vector<Change> changes;
  std::vector<VerdictChange> verdicts;
};

/// What changed from one results file to another: cells, outcomes, iterations, residuals, warnings, measurements with
/// their methods, the rows of studies, and the curve itself (column "curve moved by", the largest distance between
/// corresponding samples, infinite if there are not as many); verdicts. Numbers are held against each other bit by bit.
/// Times, messages and provenance differ between any two runs and are left out.
[[nodiscard]] Difference difference(const Results& before, const Results& after);

/// |after - before| over the larger size; infinite where one of both is not a number, or for words.
[[nodiscard]] double relative_change(const Change& change);

}  // namespace kappabench::store
