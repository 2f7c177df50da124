#pragma once

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/program/scratch_folder.hpp"
#include "experiments/run/cell.hpp"
#include "experiments/run/experiment.hpp"
#include "experiments/run/house.hpp"
#include "experiments/run/runner.hpp"
#include "reports/paper.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"
#include "tests/schemes.hpp"

namespace kappabench::test {

/// What the tests of experiments share: computing them, concluding again from changed cells, reading what they found.

/// The cells of an experiment, computed in this process; nothing is concluded.
inline store::ExperimentRecord computed(const std::string& id, const Context& context = {.registry = all_schemes()}) {
  store::ExperimentRecord record{.id = id};
  for (const CellJob& job : find_experiment(id).jobs(context)) {
    store::CellRecord cell = compute(job);
    name_cell(cell, job);
    record.cells.push_back(std::move(cell));
  }
  return record;
}

/// The cells of an experiment without their results: nothing is computed.
inline store::ExperimentRecord blank(const std::string& id, const Context& context = {.registry = all_schemes()}) {
  store::ExperimentRecord record{.id = id};
  for (const CellJob& job : find_experiment(id).jobs(context))
    name_cell(record.cells.emplace_back(store::CellRecord{.outcome = "converged"}), job);
  return record;
}

/// One experiment of a plan, run as the program does.
inline store::ExperimentRecord run_one(const PlannedExperiment& planned, int processes = 2) {
  const ScratchFolder folder;
  const RunSummary summary =
      run(all_schemes(), {.seed = 1, .experiments = {planned}},
          {.results = folder.path() / "results.h5", .processes = processes, .timeout = sanitized ? 1200.0 : 120.0});
  REQUIRE(summary.lost == 0);
  return summary.results.experiments.front();
}

/// Tables, figures and verdicts once more, from the cells as they are now.
inline store::ExperimentRecord concluded(store::ExperimentRecord record,
                                         const Context& context = {.registry = all_schemes()}) {
  record.tables.clear();
  record.figures.clear();
  record.claims.clear();
  conclude(find_experiment(record.id), context, record);
  return record;
}

/// A claim, which must have been judged, with our value and the evidence. `method`: where two are judged.
inline const store::ClaimRecord& claim_of(const store::ExperimentRecord& record, std::string_view claim,
                                          std::string_view method = {}) {
  const auto found = std::ranges::find_if(record.claims, [&](const store::ClaimRecord& judged) {
    return judged.claim == claim && (method.empty() || judged.method == method);
  });
  REQUIRE(found != record.claims.end());
  CHECK_FALSE(found->ours.empty());
  CHECK_FALSE(found->evidence.empty());
  return *found;
}

inline std::string verdict(const store::ExperimentRecord& record, std::string_view claim,
                           std::string_view method = {}) {
  return claim_of(record, claim, method).verdict;
}

/// The verdict may be that the sample is too small; this is what the sample says.
inline bool all_agree(const store::ExperimentRecord& record, std::string_view claim) {
  return claim_of(record, claim).sample.ends_with("(100 %)");
}

inline const store::TableRecord& table_of(const store::ExperimentRecord& record, std::string_view id) {
  const auto found = std::ranges::find(record.tables, id, &store::TableRecord::id);
  REQUIRE(found != record.tables.end());
  return *found;
}

/// A column of a table: of numbers, unless words are asked for.
template <class Cell = double>
const std::vector<Cell>& column_of(const store::TableRecord& table, std::string_view name) {
  const auto found = std::ranges::find(table.columns, name, &store::TableColumn::name);
  REQUIRE(found != table.columns.end());
  return std::get<std::vector<Cell>>(found->cells);
}

/// Changes every value of a column, in the cells of one scheme or in all.
inline void set_column(store::ExperimentRecord& record, std::string_view column, double value,
                       std::string_view scheme = {}) {
  const auto set = [&](std::vector<store::MeasurementRecord>& measurements) {
    for (store::MeasurementRecord& m : measurements)
      if (m.column == column) m.value = value;
  };
  for (store::CellRecord& cell : record.cells) {
    if (!scheme.empty() && cell.scheme != scheme) continue;
    for (store::TableRecord& rows : cell.rows)
      for (store::TableColumn& numbers : rows.columns)
        if (numbers.name == column && !numbers.method.empty())
          std::ranges::fill(std::get<std::vector<double>>(numbers.cells), value);
    for (store::CurveRecord& curve : cell.curves) set(curve.measurements);
  }
}

/// The same tables, figures and verdicts; NaN, where there is nothing to measure, is the same as NaN.
inline void check_same_conclusions(const store::ExperimentRecord& one, const store::ExperimentRecord& other) {
  CHECK(one.claims == other.claims);
  CHECK(one.figures == other.figures);
  REQUIRE(one.tables.size() == other.tables.size());
  const auto comparable = [](std::vector<store::TableRecord> tables) {
    for (store::TableRecord& table : tables)
      for (store::TableColumn& column : table.columns)
        if (auto* numbers = std::get_if<std::vector<double>>(&column.cells))
          std::ranges::replace_if(
              *numbers, [](double x) { return x != x; }, std::numeric_limits<double>::lowest());
    return tables;
  };
  CHECK(comparable(one.tables) == comparable(other.tables));
}

/// There are tables with rows and figures with panels.
inline void check_filled(const store::ExperimentRecord& record) {
  REQUIRE_FALSE(record.figures.empty());
  for (const store::FigureRecord& figure : record.figures) CHECK_FALSE(figure.panels.empty());
  REQUIRE_FALSE(record.tables.empty());
  for (const store::TableRecord& table : record.tables) {
    INFO(table.id);
    REQUIRE_FALSE(table.columns.empty());
    std::visit([](const auto& cells) { CHECK_FALSE(cells.empty()); }, table.columns.front().cells);
  }
}

/// Every claim of reports/paper/<paper>.toml is judged by exactly one experiment (`judged`: the claims of each), and
/// none that is not there.
inline void check_each_claim_is_judged_once(const std::string& paper, const std::multiset<std::string>& judged) {
  const Paper& printed = printed_paper(paper);
  for (const PrintedClaim& claim : printed.claims) {
    INFO(claim.id);
    CHECK(judged.count(claim.id) == 1);
  }
  CHECK(judged.size() == printed.claims.size());
}

}  // namespace kappabench::test
