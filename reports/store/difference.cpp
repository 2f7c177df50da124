#include "reports/store/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace kappabench::store {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The changes of one cell.
class CellChanges {
 public:
  CellChanges(const CellName& cell, std::vector<Change>& changes) : cell_(cell), changes_(&changes) {}

  void compare(int curve, const std::string& column, double before, double after) {
    if (!same(before, after)) changes_->push_back({cell_, curve, column, before, after});
  }
  void compare(int curve, const std::string& column, const std::string& before, const std::string& after) {
    if (before != after) changes_->push_back({cell_, curve, column, before, after});
  }

 private:
  CellName cell_;
  std::vector<Change>* changes_;
};

/// How far corresponding samples are apart.
double moved_by(const CurveRecord& before, const CurveRecord& after) {
  if (before.sample_x.size() != after.sample_x.size()) return infinite;
  double most = 0.0;
  for (std::size_t i = 0; i < before.sample_x.size(); ++i)
    most = std::max(most, std::hypot(after.sample_x[i] - before.sample_x[i], after.sample_y[i] - before.sample_y[i]));
  return most;
}

void compare_measurements(CellChanges& changes, int curve, const CurveRecord& before, const CurveRecord& after) {
  std::map<std::string, std::pair<const MeasurementRecord*, const MeasurementRecord*>> columns;
  for (const MeasurementRecord& m : before.measurements) columns[m.column].first = &m;
  for (const MeasurementRecord& m : after.measurements) columns[m.column].second = &m;
  for (const auto& [column, both] : columns) {
    const auto [old, now] = both;
    // A column that one file has not been measured for is no change of a result.
    if (old == nullptr || now == nullptr) continue;
    changes.compare(curve, column, old->value, now->value);
    changes.compare(curve, column + " method", old->method, now->method);
  }
}

void compare_curves(CellChanges& changes, int index, const CurveRecord& before, const CurveRecord& after) {
  changes.compare(index, "outcome", before.outcome, after.outcome);
  changes.compare(index, "warnings", warning_words(before), warning_words(after));
  changes.compare(index, "iterations", before.iterations, after.iterations);
  changes.compare(index, "residual", before.residual, after.residual);
  changes.compare(index, "curve moved by", 0.0, moved_by(before, after));
  compare_measurements(changes, index, before, after);
}

std::size_t length_of(const TableColumn& column) {
  return std::visit([](const auto& cells) { return cells.size(); }, column.cells);
}

void compare_columns(CellChanges& changes, const TableColumn& before, const TableColumn& after) {
  if (before.cells.index() != after.cells.index() || length_of(before) != length_of(after)) {
    changes.compare(-1, before.name + " rows", static_cast<double>(length_of(before)),
                    static_cast<double>(length_of(after)));
    return;
  }
  for (std::size_t i = 0; i < length_of(before); ++i) {
    const std::string column = fmt::format("{}[{}]", before.name, i);
    if (const auto* numbers = std::get_if<std::vector<double>>(&before.cells))
      changes.compare(-1, column, (*numbers)[i], std::get<std::vector<double>>(after.cells)[i]);
    else
      changes.compare(-1, column, std::get<std::vector<std::string>>(before.cells)[i],
                      std::get<std::vector<std::string>>(after.cells)[i]);
  }
}

void compare_rows(CellChanges& changes, const std::vector<TableRecord>& before, const std::vector<TableRecord>& after) {
  changes.compare(-1, "tables of rows", static_cast<double>(before.size()), static_cast<double>(after.size()));
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
    for (const TableColumn& old : before[i].columns) {
      const auto now = std::ranges::find(after[i].columns, old.name, &TableColumn::name);
      if (now != after[i].columns.end()) compare_columns(changes, old, *now);
    }
}

void compare_cells(CellChanges changes, const CellRecord& before, const CellRecord& after) {
  changes.compare(-1, "outcome", before.outcome, after.outcome);
  changes.compare(-1, "curves", static_cast<double>(before.curves.size()), static_cast<double>(after.curves.size()));
  for (std::size_t i = 0; i < std::min(before.curves.size(), after.curves.size()); ++i)
    compare_curves(changes, static_cast<int>(i), before.curves[i], after.curves[i]);
  compare_rows(changes, before.rows, after.rows);
}

/// The cells of a file by name, those of one name in order.
using Cells = std::map<std::pair<CellName, int>, const CellRecord*>;

Cells cells_of(const Results& results) {
  Cells cells;
  std::map<CellName, int> seen;
  for (const ExperimentRecord& experiment : results.experiments)
    for (const CellRecord& cell : experiment.cells) {
      CellName name{experiment.id, cell.dataset, cell.label};
      const int index = seen[name]++;
      cells.emplace(std::pair{std::move(name), index}, &cell);
    }
  return cells;
}

using Verdicts = std::map<std::pair<std::string, std::string>, std::string>;

Verdicts verdicts_of(const Results& results) {
  Verdicts verdicts;
  for (const ExperimentRecord& experiment : results.experiments)
    for (const ClaimRecord& claim : experiment.claims)
      verdicts[{claim.paper, claim.method.empty() ? claim.claim : claim.claim + ", " + claim.method}] = claim.verdict;
  return verdicts;
}

std::vector<VerdictChange> changed_verdicts(const Verdicts& before, const Verdicts& after) {
  std::set<std::pair<std::string, std::string>> claims;
  for (const Verdicts* verdicts : {&before, &after})
    for (const auto& entry : *verdicts) claims.insert(entry.first);
  const auto of = [](const Verdicts& verdicts, const auto& claim) {
    const auto found = verdicts.find(claim);
    return found == verdicts.end() ? std::string() : found->second;
  };
  std::vector<VerdictChange> changes;
  for (const auto& claim : claims)
    if (of(before, claim) != of(after, claim))
      changes.push_back({claim.first, claim.second, of(before, claim), of(after, claim)});
  return changes;
}

}  // namespace

Difference difference(const Results& before, const Results& after) {
  const Cells old = cells_of(before), now = cells_of(after);
  Difference result;
  for (const auto& [name, cell] : old) {
    const auto found = now.find(name);
    if (found == now.end()) {
      result.only_before.push_back(name.first);
      continue;
    }
    const std::size_t known = result.changes.size();
    compare_cells(CellChanges(name.first, result.changes), *cell, *found->second);
    ++(result.changes.size() == known ? result.equal : result.changed);
  }
  for (const auto& entry : now)
    if (!old.contains(entry.first)) result.only_after.push_back(entry.first.first);
  result.verdicts = changed_verdicts(verdicts_of(before), verdicts_of(after));
  return result;
}

double relative_change(const Change& change) {
  const auto* before = std::get_if<double>(&change.before);
  const auto* after = std::get_if<double>(&change.after);
  if (before == nullptr || after == nullptr) return infinite;
  const double relative = std::abs(*after - *before) / std::max(std::abs(*before), std::abs(*after));
  return std::isnan(relative) ? infinite : relative;
}

}  // namespace kappabench::store
