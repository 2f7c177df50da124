#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

namespace {

constexpr std::string_view about =
    "The curve is meant to pass every input point where the magnitude of its curvature peaks, inside the point's own "
    "segment. The published equations also have solutions, or only such, in which the joint sits on the input point: "
    "the point is pinned, and |curvature| passes through it without a two-sided peak. A point may also be at an "
    "inflection: its segment has shrunk to nothing. Both are counted over all drawings (without their options for "
    "single points, and without curves of more than 100 points) and over six random families, each open and closed "
    "with 3 to 50 points (trigonometric basis: 3 to 15). The slope of "
    "|curvature| on both sides of every point is measured besides, whatever the scheme says. Curves that did not "
    "converge, and straight lines, count no points.";

double value(const store::CellRecord& cell, std::string_view column) { return measured(cell, column).value_or(0.0); }

bool trigonometric(const store::CellRecord& cell) { return cell.scheme == "ekappa-trig"; }

/// Points where |kappa| does not peak inside a segment of their own, by the scheme's report.
double without_peak(const store::CellRecord& cell) { return value(cell, "pinned") + value(cell, "at inflection"); }

store::TableRecord share_table(const store::ExperimentRecord& record, bool of_trigonometric) {
  TableBuilder builder(
      of_trigonometric ? "pinned-trigonometric" : "pinned-bernstein",
      fmt::format("Pinned points against a, {} basis", of_trigonometric ? "trigonometric" : "Bernstein"),
      "A row a family and a. Points of converged curves; 'measured': by the slope of |curvature| on "
      "both sides of a point that is not pinned; 'pinned with peak': pinned, and |curvature| peaks at "
      "the joint all the same.");
  builder.words("family").numbers("a").counts("curves").counts("converged").numbers("share converged");
  builder.counts("points").counts("pinned").counts("at inflection").numbers("share pinned");
  builder.counts("measured peaks").counts("measured minima").counts("measured neither").counts("pinned with peak");
  for (const store::CellRecord& cell : record.cells) {
    if (trigonometric(cell) != of_trigonometric) continue;
    const double curves = value(cell, "curves") - value(cell, "unsupported"), points = value(cell, "points");
    builder.row({cell.dataset, value(cell, "a"), curves, value(cell, "converged"), value(cell, "converged") / curves,
                 points, value(cell, "pinned"), value(cell, "at inflection"), value(cell, "pinned") / points,
                 value(cell, "peaks"), value(cell, "valleys"), value(cell, "neither"), value(cell, "pinned peaks")});
  }
  return builder.table();
}

/// Drawings with a pinned point at any a, a column an a.
store::TableRecord drawing_table(const store::ExperimentRecord& record) {
  constexpr std::string_view prefix = "pinned of ";
  TableBuilder builder("pinned-drawings", "Drawings with pinned points",
                       "Number of pinned points by basis and a; drawings without any are left out.");
  std::map<std::string, std::vector<double>> rows;
  std::map<std::string, double> points;
  builder.words("drawing").counts("points");
  std::size_t columns = 0;
  for (const store::CellRecord& cell : record.cells) {
    if (cell.dataset != "drawings") continue;
    builder.counts(fmt::format("{} a={:.3g}", cell.scheme, value(cell, "a")));
    ++columns;
    for (const store::MeasurementRecord& m : cell.measurements) {
      if (!m.column.starts_with(prefix)) continue;
      const std::string drawing = m.column.substr(prefix.size());
      rows[drawing].resize(columns, 0.0);
      rows[drawing].back() = m.value;
      points[drawing] = std::max(points[drawing], value(cell, "points of " + drawing));
    }
  }
  for (auto& [drawing, pinned] : rows) {
    pinned.resize(columns, 0.0);
    if (std::ranges::all_of(pinned, [](double count) { return count == 0.0; })) continue;
    std::vector<TableBuilder::Cell> row{drawing, points[drawing]};
    row.insert(row.end(), pinned.begin(), pinned.end());
    builder.row(row);
  }
  return builder.table();
}

store::PanelRecord panel(std::string table, std::string title, std::string y, std::string y_label) {
  return {.kind = "graph",
          .title = std::move(title),
          .table = std::move(table),
          .x = "a",
          .y = {std::move(y)},
          .series = "family",
          .x_label = "a",
          .y_label = std::move(y_label)};
}

store::FigureRecord share_figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{
      .id = "ekappa-pinned",
      .title = "Pinned points against a",
      .caption =
          "Share of the interpolated points that are pinned: their joint sits on them and |curvature| has no "
          "two-sided peak there. One line a family of inputs.",
      .columns = 2,
      .panels = {}};
  const auto add = [&](bool of_trigonometric, const std::string& table, const std::string& title) {
    if (std::ranges::any_of(record.cells, [&](const auto& cell) { return trigonometric(cell) == of_trigonometric; }))
      figure.panels.push_back(panel(table, title, "share pinned", "share of points pinned"));
  };
  add(false, "pinned-bernstein", "Bernstein basis");
  add(true, "pinned-trigonometric", "trigonometric basis");
  return figure;
}

/// Miura 2022, Section 3, property 2, on the basis that Section 3 is about.
std::optional<store::ClaimRecord> claim(const store::ExperimentRecord& record) {
  double curves = 0, points = 0, pinned = 0, at_inflection = 0, peaks = 0, least = 1.0, most = 0.0;
  std::map<double, std::pair<double, double>> by_a;  // points, without a peak
  for (const store::CellRecord& cell : record.cells) {
    if (trigonometric(cell)) continue;
    curves += value(cell, "converged");
    points += value(cell, "points");
    pinned += value(cell, "pinned");
    at_inflection += value(cell, "at inflection");
    peaks += value(cell, "peaks");
    auto& [of_a, missing] = by_a[value(cell, "a")];
    of_a += value(cell, "points");
    missing += without_peak(cell);
    least = std::min(least, value(cell, "a"));
    most = std::max(most, value(cell, "a"));
  }
  if (points == 0.0) return std::nullopt;
  std::string shares;
  for (const auto& [a, counts] : by_a)
    shares +=
        fmt::format("{}{:.3g} % at a = {:.3g}", shares.empty() ? "" : ", ", 100.0 * counts.second / counts.first, a);
  const bool holds = pinned + at_inflection == 0.0 && peaks == points;
  return store::ClaimRecord{
      .paper = "ekappa-2022-miura",
      .claim = "extremum-at-points",
      .verdict = holds ? "reproduced" : "contradicted",
      .ours = fmt::format("{:.0f} of {:.0f} points have a peak inside their segment", peaks, points),
      .evidence = fmt::format("{:.0f} converged curves with {:.3g} <= a <= {:.3g}: {:.0f} points are pinned (the joint "
                              "sits on the point) and {:.0f} are at an inflection; together {}.",
                              curves, least, most, pinned, at_inflection, shares)};
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {share_table(record, false), share_table(record, true), drawing_table(record)};
  record.figures = {share_figure(record)};
  if (const auto verdict = claim(record)) record.claims = {*verdict};
}

}  // namespace

Experiment ekappa_pinned_experiment() {
  return {.id = "ekappa-pinned",
          .title = "Points without a peak of curvature",
          .about = std::string(about),
          .jobs = [](const Context& context) { return sweep_jobs(context, sharpness_ladder(context)); },
          .conclude = conclude};
}

}  // namespace kappabench
