// Wang 2024, Fig. 14: what does an eye find wrong with each scheme's curves through four inputs?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/visible_flaws.hpp"
#include "experiments/run/record.hpp"
#include "experiments/study/curve_marks.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/measured.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/fairness.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "Four inputs and every scheme with its curvature comb, as in Fig. 14. What the paper marks by hand with coloured "
    "boxes is found by the program and marked: joints where curvature jumps, points off the extrema of curvature, and "
    "stretches from midpoint to midpoint around a point with more than two intervals of monotone curvature.";

// ---- what is measured

constexpr std::string_view fit_label = "curve";  ///< one colour for all schemes: the panels have their names
constexpr std::string_view jump_label = "curvature jumps", off_label = "point off the extrema",
                           many_label = "more than two monotone intervals";
const study::Key scheme_key{"scheme"};
/// Those that depend on distances along the curve are sampled.
const Quantity joints = study::count_of("joints"), jumps = study::count_of("jumps"),
               sign_jumps = study::count_of("jumps where curvature changes sign"), points = study::count_of("points"),
               off_extrema{"points off extrema", "1", Method::sampled},
               off_peaks{"points off peaks", "1", Method::sampled}, pieces = study::count_of("pieces"),
               many_intervals{"pieces with more than two", "1", Method::sampled},
               alternating = study::count_of("alternating spans"),
               not_monotone{"alternating spans not monotone", "1", Method::sampled};
const std::array<const Quantity*, 10> counted{&joints,    &jumps,  &sign_jumps,     &points,      &off_extrema,
                                              &off_peaks, &pieces, &many_intervals, &alternating, &not_monotone};

/// A cell of marks on the curves of a drawing.
template <void (*Mark)(const Scheme&, const Fit&, const VisibleFlaws&, store::CellRecord&)>
void mark(const Uses& uses, store::CellRecord& cell) {
  const Scheme& scheme = *uses.schemes.front();
  for (const Input& input : uses.drawings.front().curves)
    if (const Fit fit = scheme.fit(input); fit.curve) Mark(scheme, fit, visible_flaws(fit), cell);
}

void ring(const std::vector<Vec2>& places, const Fit& fit, int corners, store::CellRecord& cell) {
  constexpr double size = 0.16;  // mean chords
  for (const Vec2& place : places) cell.curves.push_back(ring_around(place, size * mean_chord(fit.input), corners));
}

/// With the counts of everything, for the table.
void mark_jumps(const Scheme& scheme, const Fit& fit, const VisibleFlaws& flaws, store::CellRecord& cell) {
  ring(flaws.jumps, fit, 24, cell);
  Notes(cell).row({scheme_key(label_of(scheme))},
                  {joints(flaws.joints), jumps(flaws.jumps.size()), sign_jumps(flaws.jumps_at_sign_changes),
                   points(flaws.points), off_extrema(flaws.off_extrema.size()), off_peaks(flaws.points_off_peaks),
                   pieces(flaws.pieces), many_intervals(flaws.many_intervals.size()),
                   alternating(flaws.alternating_spans), not_monotone(flaws.alternating_not_monotone)});
}

void mark_off(const Scheme&, const Fit& fit, const VisibleFlaws& flaws, store::CellRecord& cell) {
  ring(flaws.off_extrema, fit, 4, cell);
}

void mark_many(const Scheme& scheme, const Fit& fit, const VisibleFlaws& flaws, store::CellRecord& cell) {
  const store::CurveRecord whole = record_of(scheme, fit, {});
  for (const auto& [start, end] : flaws.many_intervals) cell.curves.push_back(stretch_of(whole, start, end));
}

/// For each drawing and scheme four cells: the fit with all metrics, then the marks.
std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const std::vector<const Metric*> searched{&find_metric("continuity"), &find_metric("monotone_intervals"),
                                            &find_metric("extremum_offset")};
  for (const Drawing& drawing :
       study::drawings_or(context, {"row-open-7", "row-closed-10", "row-closed-9", "row-closed-7"}))
    for (const SchemePtr& scheme : study::schemes_of(context)) {
      jobs.push_back(fit_job(drawing, scheme, study::metrics_of(context), std::string(fit_label)));
      const auto add = [&](std::string_view label, void (*compute)(const Uses&, store::CellRecord&)) {
        jobs.push_back({.dataset = drawing.id,
                        .label = std::string(label),
                        .uses = {.work = fmt::format("marks: {}", label),
                                 .schemes = {scheme},
                                 .drawings = {drawing},
                                 .metrics = searched},
                        .compute = compute});
      };
      add(many_label, mark<mark_many>);
      add(jump_label, mark<mark_jumps>);
      add(off_label, mark<mark_off>);
    }
  return jobs;
}

// ---- what follows

/// A fit and the cells with marks on it.
struct Shown {
  int cell;
  std::string dataset, scheme;  ///< as it is labelled
  std::vector<int> marks{};
};

std::vector<Shown> shown_fits(const Findings& found) {
  std::vector<Shown> all;
  for (const int fit : found.labelled(fit_label)) {
    const store::CellRecord& cell = found.cell(fit);
    const std::string text = cell.parameters.empty() ? cell.scheme : cell.scheme + ":" + cell.parameters;
    all.push_back({fit, cell.dataset, label_of(*found.context().registry.parse(text))});
    for (const std::string_view label : {many_label, jump_label, off_label})
      for (const int i : found.labelled(label)) {
        const store::CellRecord& marks = found.cell(i);
        if (marks.dataset == cell.dataset && marks.scheme == cell.scheme && marks.parameters == cell.parameters &&
            !marks.curves.empty())
          all.back().marks.push_back(i);
      }
  }
  return all;
}

double metric(const Findings& found, const Shown& fit, const Column& column) {
  const auto& curves = found.cell(fit.cell).curves;
  return curves.empty() ? undefined : measured(curves.front(), column).value_or(undefined);
}

double metric(const Findings& found, std::string_view dataset, std::string_view scheme, const Column& column) {
  for (const Shown& fit : shown_fits(found))
    if (fit.dataset == dataset && fit.scheme == scheme) return metric(found, fit, column);
  return undefined;
}

Table flaw_table(const Findings& found) {
  Table table(
      "findings", "What the paper marks by hand, found",
      fmt::format(
          "Jumps: relative change of curvature at a joint above {:g}. Off the extrema: farther than {:g} of the "
          "local chord from the nearest one. Intervals of monotone curvature in the piece from midpoint to "
          "midpoint around a point. Alternating spans: between points with curvature of opposite signs. "
          "Reversals of curvature below {:g} of its range are ignored.",
          visible_jump, visible_offset, visible_reversal));
  table.words("dataset").words("scheme").words("outcome");
  for (const Quantity* count : counted) table.counts(count->name);
  table.numbers("curvature_variation").numbers("mvc_energy");
  for (const Shown& fit : shown_fits(found)) {
    std::vector<study::TableValue> row{fit.dataset, fit.scheme, found.cell(fit.cell).outcome};
    const Rows own = found.rows().where({study::key::dataset(fit.dataset), scheme_key(fit.scheme)});
    for (const Quantity* count : counted) row.emplace_back(own.empty() ? undefined : own.total(*count));
    for (const Column* column : {&column::curvature_variation, &column::mvc_energy})
      row.emplace_back(metric(found, fit, *column));
    table.row(row);
  }
  return table;
}

void add_figures(Findings& found) {
  const std::vector<Shown> shown = shown_fits(found);
  for (const std::string& dataset : found.drawn()) {
    store::FigureRecord figure{
        .id = "pkappa-comparison-" + dataset,
        .title = dataset,
        .caption =
            "Each scheme with its curvature comb, all panels to one scale. Circles: curvature "
            "jumps. Diamonds: points off the extrema of curvature. In another colour: pieces with "
            "more than two intervals of monotone curvature.",
        .columns = 4,
        .panels = {}};
    for (const Shown& fit : shown) {
      if (fit.dataset != dataset) continue;
      std::vector<int> cells{fit.cell};
      std::ranges::copy(fit.marks, std::back_inserter(cells));
      figure.panels.push_back(Panel::curves(std::move(cells), fit.scheme).comb().without_joints());
    }
    found.add(std::move(figure));
  }
}

// ---- the claims of Section 6.3

/// The paper's four kinds of curves by their counts, summed over the inputs.
double total(const Findings& found, std::string_view scheme, const Quantity& what) {
  return found.rows().where({scheme_key(scheme)}).total(what);
}

/// "kappa 1, yuksel 2".
std::string totals(const Findings& found, std::initializer_list<std::string_view> schemes, const Quantity& what) {
  std::vector<std::string> words;
  for (const std::string_view scheme : schemes)
    words.push_back(fmt::format("{} {:.0f}", scheme, total(found, scheme, what)));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// κ-curves jump, and only where curvature changes sign.
void claim_jumps(Findings& found) {
  const Tally there{.agree = total(found, "kappa", sign_jumps), .cases = total(found, "kappa", jumps)};
  found.judge(
      "kappa-jumps-at-inflections", there,
      {fmt::format("{:.0f} jumps, {:.0f} of them at inflections", there.cases, there.agree),
       fmt::format("{:.0f} joints of the kappa-curves through the four inputs.", total(found, "kappa", joints))});
}

void claim_smooth(Findings& found) {
  double all_jumps = 0.0, all_joints = 0.0;
  for (const std::string_view scheme : {"yuksel", "clothoid3", "pkappa"}) {
    all_jumps += total(found, scheme, jumps);
    all_joints += total(found, scheme, joints);
  }
  found.judge("others-do-not-jump", study::all_but(all_jumps, all_joints),
              {fmt::format("{:.0f} jumps at {:.0f} joints", all_jumps, all_joints),
               fmt::format("Jumps: {}.", totals(found, {"yuksel", "clothoid3", "pkappa"}, jumps))});
}

/// An extremum can be read as any, or as a peak of |kappa|: the reading that agrees less decides.
void claim_off(Findings& found) {
  const double cases = total(found, "yuksel", points);
  const Tally extrema{.agree = total(found, "yuksel", off_extrema), .cases = cases};
  const Tally peaks{.agree = total(found, "yuksel", off_peaks), .cases = cases};
  found.judge(
      "yuksel-off-extrema", weaker(extrema, peaks),
      {fmt::format("{} points off every extremum, {} off every peak of |kappa|", extrema.words(), peaks.words()),
       fmt::format("Off: farther than {:g} of the local chord. Where the first reading alone fails, points "
                   "are at a dip between two peaks. Others off every extremum: {}; off every peak: {}.",
                   visible_offset, totals(found, {"kappa", "clothoid3", "pkappa"}, off_extrema),
                   totals(found, {"kappa", "clothoid3", "pkappa"}, off_peaks))});
}

void claim_many(Findings& found) {
  const Tally many{.agree = total(found, "clothoid3", many_intervals), .cases = total(found, "clothoid3", pieces)};
  found.judge("clothoid3-many-intervals", many,
              {fmt::format("{} pieces", many.words()),
               fmt::format("Pieces around points with more than two intervals of monotone curvature: {}.",
                           totals(found, {"kappa", "yuksel", "clothoid3", "pkappa"}, many_intervals))});
}

void claim_alternating(Findings& found) {
  const double spans = total(found, "clothoid3", alternating);
  const Tally monotone{.agree = spans - total(found, "clothoid3", not_monotone), .cases = spans};
  found.judge("clothoid3-monotone-if-alternating", monotone,
              {fmt::format("{} spans", monotone.words()),
               "Spans of the four clothoid curves between points with curvature of opposite signs."});
}

/// Less abrupt: the integral of (d kappa / ds)^2 of the pκ-curve is below that of both others.
void claim_uniform(Findings& found) {
  Tally lower;
  std::vector<std::string> numbers;
  for (const Shown& fit : shown_fits(found)) {
    if (fit.scheme != "pkappa") continue;
    const double own = metric(found, fit, column::mvc_energy),
                 k = metric(found, fit.dataset, "kappa", column::mvc_energy),
                 y = metric(found, fit.dataset, "yuksel", column::mvc_energy);
    lower.add(own < k && own < y);
    numbers.push_back(fmt::format("{}: {:.3g} against {:.3g} and {:.3g}", fit.dataset, own, k, y));
  }
  found.judge("pkappa-more-uniform", lower,
              {fmt::format("lower on {:.0f} of {:.0f} inputs", lower.agree, lower.cases),
               fmt::format("L^3 times the integral of (d kappa / ds)^2, jumps not counted, pkappa against kappa and "
                           "yuksel. {}.",
                           fmt::join(numbers, "; "))});
}

void conclude(Findings& found) {
  found.add(flaw_table(found));
  add_figures(found);
  for (const auto claim : {claim_jumps, claim_smooth, claim_off, claim_many, claim_alternating, claim_uniform})
    claim(found);
}

}  // namespace

Experiment pkappa_comparison_experiment() {
  return study::experiment(
      {.id = "pkappa-comparison",
       .title = "Four inputs, every scheme (Wang 2024, Fig. 14)",
       .about = std::string(about),
       .paper = std::string(paper),
       .claims = {"kappa-jumps-at-inflections", "others-do-not-jump", "yuksel-off-extrema", "clothoid3-many-intervals",
                  "clothoid3-monotone-if-alternating", "pkappa-more-uniform"},
       .jobs = jobs,
       .conclude = conclude});
}

}  // namespace kappabench
