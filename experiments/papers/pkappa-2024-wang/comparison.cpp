#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/curve_findings.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/curve_marks.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "Four inputs and every scheme with its curvature comb, as in Fig. 14. What the paper marks by hand with coloured "
    "boxes is found by the program and marked: joints where curvature jumps, points off the extrema of curvature, and "
    "stretches from midpoint to midpoint around a point with more than two intervals of monotone curvature.";

constexpr int version = 1;
constexpr std::array<std::string_view, 4> inputs{"row-open-7", "row-closed-10", "row-closed-9", "row-closed-7"};

constexpr std::string_view fit_label = "curve";  ///< one colour for all schemes: the panels have their names
constexpr std::string_view jump_label = "curvature jumps", off_label = "point off the extrema",
                           many_label = "more than two monotone intervals";
constexpr double mark_size = 0.16;  ///< mean chords

std::vector<Drawing> drawings(const Context& context) {
  if (!context.datasets.empty()) return study::drawings_of(context);
  std::vector<Drawing> found;
  for (const std::string_view id : inputs) found.push_back(drawing(id));
  return found;
}

std::vector<SchemePtr> schemes(const Context& context) {
  std::vector<SchemePtr> found;
  if (context.schemes.empty())
    for (const SchemeInfo& info : context.registry.list()) found.push_back(context.registry.create(info.id));
  for (const std::string& text : context.schemes) found.push_back(context.registry.parse(text));
  return found;
}

/// The counts of the table, with the marks of the joints.
void put_counts(const Findings& found, store::CellRecord& cell) {
  study::put(cell, "joints", found.joints);
  study::put(cell, "jumps", static_cast<double>(found.jumps.size()));
  study::put(cell, "jumps where curvature changes sign", found.jumps_at_sign_changes);
  study::put(cell, "points", found.points);
  study::put(cell, "points off extrema", static_cast<double>(found.off_extrema.size()));
  study::put(cell, "points off peaks", found.points_off_peaks);
  study::put(cell, "pieces", found.pieces);
  study::put(cell, "pieces with more than two", static_cast<double>(found.many_intervals.size()));
  study::put(cell, "alternating spans", found.alternating_spans);
  study::put(cell, "alternating spans not monotone", found.alternating_not_monotone);
}

using Draw = std::function<void(const Scheme&, const Fit&, const Findings&, store::CellRecord&)>;

void draw_jumps(const Scheme&, const Fit& fit, const Findings& found, store::CellRecord& cell) {
  put_counts(found, cell);
  for (const Vec2& place : found.jumps)
    cell.curves.push_back(ring_around(place, mark_size * mean_chord(fit.input), 24));
}

void draw_off(const Scheme&, const Fit& fit, const Findings& found, store::CellRecord& cell) {
  for (const Vec2& place : found.off_extrema)
    cell.curves.push_back(ring_around(place, mark_size * mean_chord(fit.input), 4));
}

void draw_many(const Scheme& scheme, const Fit& fit, const Findings& found, store::CellRecord& cell) {
  const store::CurveRecord whole = record_of(scheme, fit, {});
  for (const auto& [start, end] : found.many_intervals) cell.curves.push_back(stretch_of(whole, start, end));
}

CellJob mark_job(const Drawing& points, const SchemePtr& scheme, std::string_view label, const Draw& draw) {
  CellJob job =
      study::study_job(points, scheme, label, version, [scheme, draw](const Drawing& d, store::CellRecord& cell) {
        for (const Input& input : d.curves)
          if (const Fit fit = scheme->fit(input); fit.curve) draw(*scheme, fit, findings(fit), cell);
      });
  job.label = label;
  return job;
}

/// For each drawing and scheme four cells: the fit with all metrics, then the marks.
std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const auto metrics = study::metrics_of(context);
  for (const Drawing& points : drawings(context))
    for (const SchemePtr& scheme : schemes(context)) {
      jobs.push_back(fit_job(points, scheme, metrics));
      jobs.back().label = fit_label;
      jobs.push_back(mark_job(points, scheme, many_label, draw_many));
      jobs.push_back(mark_job(points, scheme, jump_label, draw_jumps));
      jobs.push_back(mark_job(points, scheme, off_label, draw_off));
    }
  return jobs;
}

bool is_mark(const store::CellRecord& cell) {
  return cell.label == jump_label || cell.label == off_label || cell.label == many_label;
}

/// A fit and the cells that mark it.
struct Shown {
  int cell;
  std::vector<int> marks{};
  std::string label{};
  std::string dataset{};
};

std::string scheme_label(const Context& context, const store::CellRecord& cell) {
  const std::string parameters = cell.parameters.empty() ? "" : ":" + cell.parameters;
  return label_of(*context.registry.parse(cell.scheme + parameters));
}

std::vector<Shown> shown_of(const Context& context, const store::ExperimentRecord& record) {
  std::vector<Shown> all;
  for (std::size_t i = 0; i < record.cells.size(); ++i) {
    const store::CellRecord& cell = record.cells[i];
    if (!is_mark(cell)) {
      all.push_back({.cell = static_cast<int>(i), .label = scheme_label(context, cell), .dataset = cell.dataset});
      continue;
    }
    for (Shown& shown : all) {
      const store::CellRecord& fit = record.cells[static_cast<std::size_t>(shown.cell)];
      if (fit.dataset == cell.dataset && fit.scheme == cell.scheme && fit.parameters == cell.parameters)
        shown.marks.push_back(static_cast<int>(i));
    }
  }
  return all;
}

/// The cells and how they belong together.
struct Results {
  const store::ExperimentRecord& record;
  std::vector<Shown> shown;

  [[nodiscard]] const store::CellRecord& cell(int i) const { return record.cells[static_cast<std::size_t>(i)]; }

  /// The count of a fit; NaN without a curve.
  [[nodiscard]] double count(const Shown& fit, std::string_view column) const {
    for (const int mark : fit.marks)
      if (const auto value = measured(cell(mark), column)) return *value;
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// Sum of the counts of a scheme.
  [[nodiscard]] double total(std::string_view label, std::string_view column) const {
    double sum = 0.0;
    for (const Shown& fit : shown)
      if (const double n = count(fit, column); fit.label == label && !std::isnan(n)) sum += n;
    return sum;
  }

  /// A metric of a fit, by drawing and scheme; NaN if there is none.
  [[nodiscard]] double metric(std::string_view dataset, std::string_view label, std::string_view column) const {
    for (const Shown& fit : shown)
      if (fit.dataset == dataset && fit.label == label && !cell(fit.cell).curves.empty())
        return measured(cell(fit.cell).curves.front(), column).value_or(std::numeric_limits<double>::quiet_NaN());
    return std::numeric_limits<double>::quiet_NaN();
  }
};

constexpr std::array<std::string_view, 10> counted_columns{"joints",
                                                           "jumps",
                                                           "jumps where curvature changes sign",
                                                           "points",
                                                           "points off extrema",
                                                           "points off peaks",
                                                           "pieces",
                                                           "pieces with more than two",
                                                           "alternating spans",
                                                           "alternating spans not monotone"};

store::TableRecord findings_table(const Results& results) {
  TableBuilder builder(
      "findings", "What the paper marks by hand, found",
      fmt::format(
          "Jumps: relative change of curvature at a joint above {:g}. Off the extrema: farther than {:g} of the "
          "local chord from the nearest one. Intervals of monotone curvature in the piece from midpoint to "
          "midpoint around a point. Alternating spans: between points with curvature of opposite signs. "
          "Reversals of curvature below {:g} of its range are ignored.",
          visible_jump, visible_offset, visible_reversal));
  builder.words("dataset").words("scheme").words("outcome");
  for (const std::string_view column : counted_columns) builder.counts(std::string(column));
  builder.numbers("curvature_variation").numbers("mvc_energy");
  for (const Shown& fit : results.shown) {
    const store::CellRecord& cell = results.cell(fit.cell);
    std::vector<TableBuilder::Cell> row{fit.dataset, fit.label, cell.outcome};
    for (const std::string_view column : counted_columns) row.emplace_back(results.count(fit, column));
    for (const std::string_view column : {"curvature_variation", "mvc_energy"})
      row.emplace_back(results.metric(fit.dataset, fit.label, column));
    builder.row(row);
  }
  return builder.table();
}

store::FigureRecord figure(const std::string& dataset, const std::vector<Shown>& shown) {
  store::FigureRecord figure{.id = "pkappa-comparison-" + dataset,
                             .title = dataset,
                             .caption =
                                 "Each scheme with its curvature comb, all panels to one scale. Circles: curvature "
                                 "jumps. Diamonds: points off the extrema of curvature. In another colour: pieces with "
                                 "more than two intervals of monotone curvature.",
                             .columns = 4,
                             .panels = {}};
  for (const Shown& s : shown) {
    if (s.dataset != dataset) continue;
    std::vector<int> cells{s.cell};
    std::ranges::copy(s.marks, std::back_inserter(cells));
    store::PanelRecord panel = curve_panel(std::move(cells), s.label, true);
    panel.joints = false;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

std::vector<store::FigureRecord> figures(const Results& results) {
  std::vector<Shown> shown = results.shown;
  for (Shown& s : shown) std::erase_if(s.marks, [&](int mark) { return results.cell(mark).curves.empty(); });
  std::vector<std::string> datasets;
  for (const Shown& s : shown)
    if (std::ranges::find(datasets, s.dataset) == datasets.end()) datasets.push_back(s.dataset);
  std::vector<store::FigureRecord> figures;
  for (const std::string& dataset : datasets) figures.push_back(figure(dataset, shown));
  return figures;
}

// --- Section 6.3 ---

/// κ-curves jump, and only where curvature changes sign.
store::ClaimRecord jumps_claim(const Results& results) {
  const double jumps = results.total("kappa", "jumps");
  const double there = results.total("kappa", "jumps where curvature changes sign");
  return claim(
      "kappa-jumps-at-inflections", study::verdict_for_all(jumps - there, jumps),
      fmt::format("{:.0f} jumps, {:.0f} of them at inflections", jumps, there),
      fmt::format("{:.0f} joints of the kappa-curves through the four inputs.", results.total("kappa", "joints")));
}

store::ClaimRecord smooth_claim(const Results& results) {
  double jumps = 0.0, joints = 0.0;
  for (const std::string_view label : {"yuksel", "clothoid3", "pkappa"}) {
    jumps += results.total(label, "jumps");
    joints += results.total(label, "joints");
  }
  return claim("others-do-not-jump", study::verdict_for_all(jumps, joints),
               fmt::format("{:.0f} jumps at {:.0f} joints", jumps, joints),
               fmt::format("Jumps: yuksel {:.0f}, clothoid3 {:.0f}, pkappa {:.0f}.", results.total("yuksel", "jumps"),
                           results.total("clothoid3", "jumps"), results.total("pkappa", "jumps")));
}

/// An extremum can be read as any, or as a peak of |kappa|: the weaker verdict of the two readings.
store::ClaimRecord off_claim(const Results& results) {
  const double points = results.total("yuksel", "points");
  const Tally off{.agree = results.total("yuksel", "points off extrema"), .cases = points};
  const Tally off_peaks{.agree = results.total("yuksel", "points off peaks"), .cases = points};
  const std::string verdict = verdict_often(off), of_peaks = verdict_often(off_peaks);
  const auto others = [&](std::string_view column) {
    return fmt::format("kappa {:.0f}, clothoid3 {:.0f}, pkappa {:.0f}", results.total("kappa", column),
                       results.total("clothoid3", column), results.total("pkappa", column));
  };
  return claim("yuksel-off-extrema", verdict == of_peaks ? verdict : "not reproduced",
               fmt::format("{} points off every extremum, {} off every peak of |kappa|",
                           study::share(off.agree, points), study::share(off_peaks.agree, points)),
               fmt::format("Off: farther than {:g} of the local chord. Where the first reading alone fails, points "
                           "are at a dip between two peaks. Others off every extremum: {}; off every peak: {}.",
                           visible_offset, others("points off extrema"), others("points off peaks")));
}

/// "Multiple" stretches: two at least. None at all is a contradiction.
store::ClaimRecord many_claim(const Results& results) {
  const double many = results.total("clothoid3", "pieces with more than two");
  return claim("clothoid3-many-intervals",
               many >= 2.0                                                 ? "reproduced"
               : many == 0.0 && results.total("clothoid3", "pieces") > 0.0 ? "contradicted"
                                                                           : "not reproduced",
               fmt::format("{:.0f} of {:.0f} pieces", many, results.total("clothoid3", "pieces")),
               fmt::format("Pieces around points with more than two intervals of monotone curvature: kappa {:.0f}, "
                           "yuksel {:.0f}, clothoid3 {:.0f}, pkappa {:.0f}.",
                           results.total("kappa", "pieces with more than two"),
                           results.total("yuksel", "pieces with more than two"), many,
                           results.total("pkappa", "pieces with more than two")));
}

store::ClaimRecord alternating_claim(const Results& results) {
  const double spans = results.total("clothoid3", "alternating spans");
  const double against = results.total("clothoid3", "alternating spans not monotone");
  return claim("clothoid3-monotone-if-alternating", study::verdict_for_all(against, spans),
               fmt::format("{} spans", study::share(spans - against, spans)),
               "Spans of the four clothoid curves between points with curvature of opposite signs.");
}

/// Less abrupt: the integral of (d kappa / ds)^2 of the pκ-curve is below that of both others.
store::ClaimRecord uniform_claim(const Results& results) {
  Tally lower;
  std::vector<std::string> numbers;
  const auto energy = [&](const std::string& dataset, std::string_view label) {
    return results.metric(dataset, label, "mvc_energy");
  };
  for (const Shown& s : results.shown) {
    if (s.label != "pkappa") continue;
    const double own = energy(s.dataset, "pkappa"), k = energy(s.dataset, "kappa"), y = energy(s.dataset, "yuksel");
    if (std::isnan(own) || std::isnan(k) || std::isnan(y)) continue;
    lower.add(own < k && own < y);
    numbers.push_back(fmt::format("{}: {:.3g} against {:.3g} and {:.3g}", s.dataset, own, k, y));
  }
  return claim("pkappa-more-uniform", study::verdict_for_all(lower.cases - lower.agree, lower.cases),
               fmt::format("lower on {:.0f} of {:.0f} inputs", lower.agree, lower.cases),
               fmt::format("L^3 times the integral of (d kappa / ds)^2, jumps not counted, pkappa against kappa and "
                           "yuksel. {}.",
                           fmt::join(numbers, "; ")));
}

void conclude(const Context& context, store::ExperimentRecord& record) {
  const Results results{record, shown_of(context, record)};
  record.tables = {findings_table(results)};
  record.figures = figures(results);
  record.claims = {jumps_claim(results), smooth_claim(results),      off_claim(results),
                   many_claim(results),  alternating_claim(results), uniform_claim(results)};
}

}  // namespace

Experiment pkappa_comparison_experiment() {
  return {.id = "pkappa-comparison",
          .title = "Four inputs, every scheme (Wang 2024, Fig. 14)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
