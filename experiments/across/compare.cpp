#include "experiments/across/compare.hpp"
#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

namespace {

constexpr std::string_view about =
    "Every scheme on the same points, drawn with its curvature comb, and every metric beside it. A fit that did not "
    "converge, or input that a scheme does not take, is a row like any other. Unless drawings are named, those with "
    "more than 200 points in a curve are left out.";

/// Larger drawings are left to the study of growth, unless they are asked for: one of them takes as long as fifty of
/// the others.
constexpr int most_points_by_default = 200;

bool too_large(const Context& context, const Drawing& drawing) {
  return context.datasets.empty() &&
         std::ranges::any_of(drawing.curves, [](const Input& input) { return input.size() > most_points_by_default; });
}

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<SchemePtr> schemes = study::schemes_of(context);
  const std::vector<const Metric*> metrics = study::metrics_of(context);
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : study::drawings_of(context)) {
    if (too_large(context, drawing)) continue;
    for (const SchemePtr& scheme : schemes) jobs.push_back(fit_job(drawing, scheme, metrics));
  }
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

constexpr std::array<std::string_view, 3> distributed{"parabola_energy_centred_scaled_mean",
                                                      "prominent_intervals_per_centred_piece_max", "mvc_energy"};
constexpr std::string_view profile_column = "share of curves";

/// The curves by scheme in the order of the cells; `value` NaN for a curve that is left out.
std::vector<std::pair<std::string, std::vector<double>>> by_scheme(
    const store::ExperimentRecord& record, const std::function<double(const store::CurveRecord&)>& value) {
  std::vector<std::pair<std::string, std::vector<double>>> found;
  for (const store::CellRecord& cell : record.cells) {
    auto scheme = std::ranges::find(found, cell.label, &std::pair<std::string, std::vector<double>>::first);
    if (scheme == found.end()) scheme = found.insert(found.end(), {cell.label, {}});
    for (const store::CurveRecord& curve : cell.curves) scheme->second.push_back(value(curve));
  }
  return found;
}

/// Empirical distribution functions, at most 50 steps each. A curve that did not converge, or has an infinite value,
/// is never below anything: the function ends below 1.
store::TableRecord distribution_table(const store::ExperimentRecord& record, std::string_view column) {
  constexpr std::size_t steps = 50;
  constexpr double least_shown = 1e-12, most_shown = 1e9;  // beyond: rounding, and all but cusps
  TableBuilder builder(fmt::format("distribution-{}", column), fmt::format("Distribution of {}", column),
                       "Share of all curves given to a scheme on which it converged with at most this value. Values "
                       "outside 1e-12 to 1e9 are put at these ends.");
  builder.words("scheme").numbers(std::string(column)).numbers("share of curves");
  for (auto& [label, values] : by_scheme(record, [column](const store::CurveRecord& curve) {
         const auto value = curve.outcome == name(Outcome::converged) ? measured(curve, column) : std::nullopt;
         return value.value_or(std::numeric_limits<double>::quiet_NaN());
       })) {
    const auto all = static_cast<double>(values.size());
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    for (double& v : values) v = std::clamp(v, least_shown, most_shown);
    std::ranges::sort(values);
    const std::size_t n = values.size(), shown = std::min(n, steps);
    for (std::size_t k = 1; k <= shown; ++k) {
      const std::size_t below = k * n / shown;
      builder.row({label, values[below - 1], static_cast<double>(below) / all});
    }
  }
  return builder.table();
}

/// Performance profiles of Dolan and More (Math. Program. 91, 2002): the share of curves that a scheme solves within
/// a factor of the fastest scheme's time.
store::TableRecord profile_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "profile-seconds", "Time of a fit against the fastest scheme's",
      "Share of all curves on which a scheme converged within a factor of the time of the fastest that "
      "converged there. Single fits on a machine that may be busy: experiments on timing repeat.");
  builder.words("scheme").numbers("factor").numbers(std::string(profile_column));
  auto seconds = by_scheme(record, [](const store::CurveRecord& curve) {
    return curve.outcome == name(Outcome::converged) ? curve.seconds : std::numeric_limits<double>::infinity();
  });
  std::size_t curves = 0;
  for (const auto& [label, values] : seconds) curves = std::max(curves, values.size());
  // A scheme whose cell was lost has no row for the curve: curves could not be matched.
  std::erase_if(seconds, [curves](const auto& scheme) { return scheme.second.size() != curves; });
  std::vector<double> fastest(curves, std::numeric_limits<double>::infinity());
  for (const auto& [label, values] : seconds)
    for (std::size_t i = 0; i < curves; ++i) fastest[i] = std::min(fastest[i], values[i]);
  for (const auto& [label, values] : seconds)
    for (int k = 0; k <= 40; ++k) {  // factors 1 to 10^5, eight a decade
      const double factor = std::pow(10.0, k / 8.0);
      double within = 0.0;
      for (std::size_t i = 0; i < curves; ++i)
        within += std::isfinite(values[i]) && values[i] <= factor * fastest[i] ? 1.0 : 0.0;
      builder.row({label, factor, within / static_cast<double>(curves)});
    }
  return builder.table();
}

store::FigureRecord distribution_figure() {
  store::FigureRecord figure{
      .id = "compare-distributions",
      .title = "Distributions over all curves",
      .caption =
          "Share of curves on which a scheme converged with at most the value on the axis; last, "
          "within a factor of the fastest scheme's time (profiles of Dolan and Moré).",
      .columns = 2,
      .panels = {}};
  const auto graph = [&](std::string title, std::string table, std::string_view x, bool log, std::string x_label) {
    store::PanelRecord panel{.kind = "graph", .title = std::move(title)};
    panel.table = std::move(table);
    panel.x = x;
    panel.y = {std::string(profile_column)};
    panel.series = "scheme";
    panel.log_x = log;
    panel.x_label = std::move(x_label);
    figure.panels.push_back(std::move(panel));
  };
  graph("parabola-fit energy", fmt::format("distribution-{}", distributed[0]), distributed[0], true,
        "E_p times mean chord, mean over pieces");
  graph("intervals of monotone curvature", fmt::format("distribution-{}", distributed[1]), distributed[1], false,
        "most in a piece, small reversals ignored");
  graph("variation of curvature", fmt::format("distribution-{}", distributed[2]), distributed[2], true,
        "L^3 times integral of (dκ/ds)^2");
  graph("time of a fit", "profile-seconds", "factor", true, "factor of the fastest scheme's time");
  return figure;
}

/// Drawings shown when nobody chose any: of each kind one. The tables have all.
constexpr std::array<std::string_view, 8> shown_by_default{
    "bird", "christmas-tree", "circle-uneven", "letter-r", "near-collinear", "s-inflections", "star", "very-uneven"};

/// For each drawing, a panel a scheme with combs.
std::vector<store::FigureRecord> figures(const Context& context, const store::ExperimentRecord& record) {
  std::vector<store::FigureRecord> figures;
  for (std::size_t i = 0; i < record.cells.size();) {
    const std::string& dataset = record.cells[i].dataset;
    store::FigureRecord figure{.id = "compare-" + dataset, .title = dataset, .caption = {}};
    figure.caption =
        "Each scheme with its curvature comb, all panels to one scale. Squares: input points; small circles: joints.";
    for (; i < record.cells.size() && record.cells[i].dataset == dataset; ++i) {
      store::PanelRecord panel{.kind = "curve", .title = record.cells[i].label, .cells = {static_cast<int>(i)}};
      panel.comb = true;
      figure.panels.push_back(std::move(panel));
    }
    const bool shown =
        !context.datasets.empty() || std::ranges::find(shown_by_default, dataset) != shown_by_default.end();
    if (shown) figures.push_back(std::move(figure));
  }
  return figures;
}

/// One curve, and for convergence one that iterates.
bool drawable(const store::CellRecord& cell, std::string_view kind) {
  return cell.curves.size() == 1 && (kind != "convergence" || !cell.curves.front().trace.empty());
}

/// Curvature against arc length, and residual against iteration: all schemes over one another, a panel a drawing, for
/// the first few drawings of a single curve.
store::FigureRecord overlay(const store::ExperimentRecord& record, std::string kind, std::string title,
                            std::string caption) {
  constexpr std::size_t most_panels = 6;
  store::FigureRecord figure{.id = "compare-all-" + kind, .title = std::move(title), .caption = std::move(caption)};
  for (std::size_t i = 0; i < record.cells.size() && figure.panels.size() < most_panels;) {
    const std::string& dataset = record.cells[i].dataset;
    store::PanelRecord panel{.kind = kind, .title = dataset};
    for (; i < record.cells.size() && record.cells[i].dataset == dataset; ++i)
      if (drawable(record.cells[i], kind)) panel.cells.push_back(static_cast<int>(i));
    const bool known = std::ranges::find(shown_by_default, dataset) != shown_by_default.end();
    if (panel.cells.size() > 1 && (known || record.cells.size() < 100)) figure.panels.push_back(std::move(panel));
  }
  return figure;
}

void conclude(const Context& context, store::ExperimentRecord& record) {
  record.tables = {scheme_table(record), curve_table(record), profile_table(record)};
  for (const std::string_view column : distributed) record.tables.push_back(distribution_table(record, column));
  record.figures = figures(context, record);
  record.figures.push_back(distribution_figure());
  for (store::FigureRecord& figure :
       std::vector{overlay(record, "curvature", "Curvature", "Curvature against arc length, nodes marked."),
                   overlay(record, "convergence", "Convergence",
                           "Residual of each scheme's own equations, scale-free, before and after each iteration.")})
    if (!figure.panels.empty()) record.figures.push_back(std::move(figure));
}

}  // namespace

Experiment compare_experiment() {
  return {.id = "compare",
          .title = "All schemes on all drawings",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
