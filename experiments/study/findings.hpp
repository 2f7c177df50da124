#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/panel.hpp"
#include "experiments/study/rows.hpp"
#include "experiments/study/table.hpp"
#include "experiments/study/tally.hpp"
#include "experiments/study/verdicts.hpp"
#include "metrics/statistics.hpp"

namespace kappabench::study {

/// What an experiment says of a claim in its own words.
struct Said {
  std::string ours;      ///< our number or words
  std::string evidence;  ///< one or two sentences, with counts
  std::string method{};  ///< whose method was judged, where there are two
};

/// The finished cells of an experiment, to read from, and its tables, figures and verdicts, to write to.
class Findings {
 public:
  /// `paper`: what reports/paper/<paper>.toml is about. All of them must outlive the findings.
  Findings(const Context& context, std::string_view paper, store::ExperimentRecord& record)
      : context_(&context), paper_(paper), record_(&record), rows_(record.cells) {}

  [[nodiscard]] const Context& context() const { return *context_; }

  /// Every row that a measurement put (Notes).
  [[nodiscard]] const Rows& rows() const { return rows_; }

  [[nodiscard]] const std::vector<store::CellRecord>& cells() const { return record_->cells; }
  [[nodiscard]] const store::CellRecord& cell(int index) const { return cells()[static_cast<std::size_t>(index)]; }
  /// Index of the first cell with this data set and label, or nothing.
  [[nodiscard]] std::optional<int> find(std::string_view dataset, std::string_view label) const;
  /// The cells whose label is this, as indices.
  [[nodiscard]] std::vector<int> labelled(std::string_view label) const;
  /// The data sets that have drawn curves, in order.
  [[nodiscard]] std::vector<std::string> drawn() const;
  /// The first curve of a cell; null where there is none to draw.
  [[nodiscard]] const store::CurveRecord* curve(int cell) const;

  void add(const Table& table) { record_->tables.push_back(table.record()); }
  void add(store::FigureRecord figure);  ///< one without panels is left out

  // Verdicts on claims of the paper, by the rules of verdicts.hpp.

  /// Of the kinds always, in general, often, may.
  void judge(std::string_view id, const Tally& sample, Said said);
  /// Of the kinds growth and number.
  void judge(std::string_view id, const Interval& measured, Said said);
  /// A formula that holds corrected if not as printed.
  void judge_formula(std::string_view id, const Tally& printed, const Tally& corrected, Said said);
  /// What decides is not printed; the evidence shows how.
  void undecidable(std::string_view id, Said said);
  /// What was tested could not have failed.
  void by_construction(std::string_view id, Said said);

 private:
  void add_claim(std::string_view id, Ruling ruling, Said said);

  const Context* context_;
  std::string_view paper_;
  store::ExperimentRecord* record_;
  Rows rows_;
};

}  // namespace kappabench::study
