#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench::study {

/// What the experiments on the figures of all papers share: cells that keep numbers or a drawn curve, and finding them
/// again when it comes to conclusions.

/// A cell to draw: no metrics, a label of our own.
[[nodiscard]] CellJob drawn_job(const Drawing& drawing, const SchemePtr& scheme, std::string label);

/// A cell of numbers about one drawing under many parameters: `measure` calls `put`. Raise `version` when its
/// results change. `measure` must depend on the drawing, the registry's schemes and constants of the program alone.
[[nodiscard]] CellJob study_job(const Drawing& drawing, const SchemePtr& scheme, std::string_view name, int version,
                                std::function<void(const Drawing&, store::CellRecord&)> measure);

/// Appends a measurement. A column may come several times: one value for each joint, point, curve, ...
void put(store::CellRecord& cell, std::string column, double value, Method method = Method::exact);

/// All values of a column over all cells, in order, or over those of one drawing; and their sum.
[[nodiscard]] std::vector<double> values(const store::ExperimentRecord& record, std::string_view column,
                                         std::string_view dataset = {});
[[nodiscard]] double total(const store::ExperimentRecord& record, std::string_view column,
                           std::string_view dataset = {});

/// Index of the drawn cell with this label, or nothing.
[[nodiscard]] std::optional<int> drawn_cell(const store::ExperimentRecord& record, std::string_view dataset,
                                            std::string_view label);
/// The drawings that have drawn cells, in order.
[[nodiscard]] std::vector<std::string> drawn_datasets(const store::ExperimentRecord& record);

/// Every point of the drawings as text, for the keys of cells.
[[nodiscard]] std::string contents_of(const std::vector<Drawing>& drawings);

/// The largest of the spans' deviations at each distance 1 ... farthest from the point, in spans: those that meet at
/// the point are at distance 1. NaN where there is no span.
[[nodiscard]] std::vector<double> largest_by_distance(std::span<const Span> spans, std::span<const double> deviations,
                                                      int point, bool closed, int farthest);

}  // namespace kappabench::study
