#include "experiments/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/summaries.hpp"

namespace kappabench {

namespace {

constexpr std::string_view about =
    "Every scheme on the same points, drawn with its curvature comb, and every metric beside it. A fit that did not "
    "converge, or input that a scheme does not take, is a row like any other.";

/// One of each scheme; the εκ family at the sharpness that its paper shows most.
std::vector<SchemePtr> schemes_of(const Context& context) {
  std::vector<SchemePtr> schemes;
  if (context.schemes.empty())
    for (const SchemeInfo& info : context.registry.list()) schemes.push_back(context.registry.create(info.id));
  for (const std::string& text : context.schemes) schemes.push_back(context.registry.parse(text));
  return schemes;
}

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<SchemePtr> schemes = schemes_of(context);
  const std::vector<const Metric*> metrics = metrics_of(context);
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : drawings_of(context))
    for (const SchemePtr& scheme : schemes) jobs.push_back(fit_job(drawing, scheme, metrics));
  return jobs;
}

/// Columns in the order of the metrics, as far as any curve has them.
std::vector<store::MeasurementRecord> columns_of(const store::ExperimentRecord& record) {
  std::vector<store::MeasurementRecord> columns;
  for (const store::CellRecord& cell : record.cells)
    for (const store::CurveRecord& curve : cell.curves)
      if (curve.measurements.size() > columns.size()) columns = curve.measurements;
  return columns;
}

store::TableRecord curve_table(const store::ExperimentRecord& record) {
  TableBuilder builder(std::string(compare_table_id), "Every curve, every scheme",
                       "One row a curve and scheme. The methods (exact, enclosed, sampled) are in the results file.");
  builder.words("dataset").counts("curve").words("scheme").counts("points").words("outcome").counts("iterations");
  builder.numbers("residual").counts("pinned").counts("at inflection");
  const auto columns = columns_of(record);
  for (const auto& column : columns) builder.numbers(column.column, column.unit);
  for (const store::CellRecord& cell : record.cells)
    for (std::size_t i = 0; i < cell.curves.size(); ++i) {
      const store::CurveRecord& curve = cell.curves[i];
      std::vector<TableBuilder::Cell> row{cell.dataset,
                                          static_cast<double>(i),
                                          cell.label,
                                          static_cast<double>(curve.point_x.size()),
                                          curve.outcome,
                                          static_cast<double>(curve.iterations),
                                          curve.residual,
                                          static_cast<double>(counted(curve, "pinned")),
                                          static_cast<double>(counted(curve, "at_inflection"))};
      for (const auto& column : columns)
        row.emplace_back(measured(curve, column.column).value_or(std::numeric_limits<double>::quiet_NaN()));
      builder.row(row);
    }
  return builder.table();
}

/// What a scheme did over all curves.
struct Tally {
  double curves = 0, converged = 0, not_converged = 0, unsupported = 0, lost = 0, pinned = 0, at_inflection = 0,
         points = 0;
  std::vector<double> iterations{};
  std::map<std::string, std::vector<double>> values{};
};

void add(Tally& tally, const store::CurveRecord& curve, const std::vector<std::string>& columns) {
  ++tally.curves;
  tally.points += static_cast<double>(curve.point_x.size());
  if (curve.outcome == name(Outcome::converged)) {
    ++tally.converged;
  } else if (curve.outcome == name(Outcome::not_converged)) {
    ++tally.not_converged;
  } else if (curve.outcome == name(Outcome::unsupported_input)) {
    ++tally.unsupported;
    return;
  } else {
    ++tally.lost;
  }
  tally.pinned += static_cast<double>(counted(curve, "pinned"));
  tally.at_inflection += static_cast<double>(counted(curve, "at_inflection"));
  tally.iterations.push_back(curve.iterations);
  for (const std::string& column : columns)
    if (const auto value = measured(curve, column)) tally.values[column].push_back(*value);
}

store::TableRecord scheme_table(const store::ExperimentRecord& record) {
  std::vector<std::string> columns;
  for (const auto& column : columns_of(record)) columns.push_back(column.column);
  std::vector<std::pair<std::string, Tally>> tallies;
  for (const store::CellRecord& cell : record.cells) {
    auto found = std::ranges::find(tallies, cell.label, &std::pair<std::string, Tally>::first);
    if (found == tallies.end()) found = tallies.insert(tallies.end(), {cell.label, {}});
    if (cell.curves.empty()) found->second.lost += 1;
    for (const store::CurveRecord& curve : cell.curves) add(found->second, curve, columns);
  }

  TableBuilder builder("schemes", "Each scheme over all curves",
                       "Counts of curves by outcome and of points that are pinned or at an inflection; medians over "
                       "the curves that have the metric.");
  builder.words("scheme").counts("curves").counts("converged").counts("not converged").counts("unsupported");
  builder.counts("lost").counts("points").counts("pinned").counts("at inflection").numbers("median iterations");
  for (const auto& column : columns_of(record)) builder.numbers("median " + column.column, column.unit);
  for (const auto& [label, tally] : tallies) {
    std::vector<TableBuilder::Cell> row{
        label,      tally.curves, tally.converged, tally.not_converged, tally.unsupported,
        tally.lost, tally.points, tally.pinned,    tally.at_inflection, median(tally.iterations)};
    for (const std::string& column : columns) {
      const auto values = tally.values.find(column);
      row.emplace_back(median(values == tally.values.end() ? std::vector<double>{} : values->second));
    }
    builder.row(row);
  }
  return builder.table();
}

/// For each drawing, a panel a scheme with combs, and a figure of their curvature.
std::vector<store::FigureRecord> figures(const store::ExperimentRecord& record) {
  std::vector<store::FigureRecord> figures;
  for (std::size_t i = 0; i < record.cells.size();) {
    const std::string& dataset = record.cells[i].dataset;
    store::FigureRecord figure{.id = "compare-" + dataset, .title = dataset, .caption = {}};
    figure.caption = fmt::format(
        "{}: each scheme with its curvature comb, to one scale a panel. Squares: input points; small circles: joints.",
        dataset);
    for (; i < record.cells.size() && record.cells[i].dataset == dataset; ++i) {
      store::PanelRecord panel{.kind = "curve", .title = record.cells[i].label, .cells = {static_cast<int>(i)}};
      panel.comb = true;
      figure.panels.push_back(std::move(panel));
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {scheme_table(record), curve_table(record)};
  record.figures = figures(record);
}

}  // namespace

std::vector<Drawing> drawings_of(const Context& context) {
  if (context.datasets.empty()) return builtin_drawings();
  std::vector<Drawing> drawings;
  for (const std::string& name : context.datasets) std::ranges::move(open_drawings(name), std::back_inserter(drawings));
  return drawings;
}

std::vector<const Metric*> metrics_of(const Context& context) {
  std::vector<const Metric*> metrics;
  for (const std::string& id : context.metrics) metrics.push_back(&find_metric(id));
  if (metrics.empty())
    for (const Metric& metric : all_metrics()) metrics.push_back(&metric);
  return metrics;
}

Experiment compare_experiment() {
  return {.id = "compare",
          .title = "All schemes on all drawings",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
