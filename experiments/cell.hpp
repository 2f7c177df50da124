#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datasets/drawing.hpp"
#include "metrics/metric.hpp"
#include "reports/store/model.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench {

/// A piece of an experiment that can be computed on its own, in a process of its own.
struct CellJob {
  std::string dataset;
  std::string scheme;      ///< id
  std::string parameters;  ///< canonical
  std::string label;       ///< for legends and tables
  /// Hash of all that the result depends on: scheme and version, parameters, data, metrics and versions.
  /// Equal keys mean equal results, so that a finished cell need not be computed again.
  std::string key;
  std::function<store::CellRecord()> compute;
};

/// The usual job: fit every curve of the drawing, then measure. The label is the scheme's id with the parameters
/// that differ from their defaults.
[[nodiscard]] CellJob fit_job(const Drawing& drawing, SchemePtr scheme, std::vector<const Metric*> metrics);

/// A job of another kind (a sweep over random inputs, a timing): `compute` fills outcome, curves, measurements or
/// timings. `what` names everything that its result depends on besides the scheme.
[[nodiscard]] CellJob other_job(std::string dataset, const SchemePtr& scheme, const std::string& what,
                                std::function<void(store::CellRecord&)> compute);

/// "ekappa a=0.8".
[[nodiscard]] std::string label_of(const Scheme& scheme);

}  // namespace kappabench
