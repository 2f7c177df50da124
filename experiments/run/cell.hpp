#pragma once

#include <string>
#include <vector>

#include "experiments/run/uses.hpp"
#include "reports/store/model.hpp"

namespace kappabench {

/// A piece of an experiment that can be computed on its own, in a process of its own.
struct CellJob {
  std::string dataset;
  std::string label;  ///< for legends and tables
  Uses uses;
  /// Fills outcome, curves, rows and timings. A plain function: it can depend on nothing that `uses`, and so the key,
  /// does not name.
  void (*compute)(const Uses& uses, store::CellRecord& cell);

  [[nodiscard]] std::string key() const { return key_of(uses); }
};

/// The job's cell; what it throws is thrown.
[[nodiscard]] store::CellRecord compute(const CellJob& job);

/// The usual job: fit every curve of the drawing, then measure. The label is the scheme's id with the parameters
/// that differ from their defaults.
[[nodiscard]] CellJob fit_job(const Drawing& drawing, const SchemePtr& scheme, std::vector<const Metric*> metrics);

/// A cell that is to be drawn: as fit_job, with a label of its own.
[[nodiscard]] CellJob fit_job(const Drawing& drawing, const SchemePtr& scheme, std::vector<const Metric*> metrics,
                              std::string label);

/// Fits with the first scheme and keeps every curve of the drawings with what the metrics say of it: what fit_job
/// computes. The outcome of a cell is the worst of its curves'.
void fit_and_measure(const Uses& uses, store::CellRecord& cell);

/// Who the cell is: dataset, scheme, parameters, label and key of the job.
void name_cell(store::CellRecord& cell, const CellJob& job);

/// "ekappa a=0.8".
[[nodiscard]] std::string label_of(const Scheme& scheme);

}  // namespace kappabench
