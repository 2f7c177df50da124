// Wang 2024, Fig. 13: what do C1, G1, C2 and G2 joints make of the same points?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/random_points.hpp"
#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/papers/pkappa-2024-wang/two_ways.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/measured.hpp"
#include "metrics/continuity.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "The same drawing with C1, G1, C2 and G2 joints, as in Fig. 13. Then random curves of ten points for each, open "
    "ones window by window and closed ones all at once (and window by window, where closing is hardest): how many are "
    "not solved, how near the curvature is to parabolas, how many segments have at most two intervals of monotone "
    "curvature, how near the points are to extrema of curvature.";

struct Kind {
  std::string_view words, option;
  double mean, largest;  ///< Fig. 13
};
constexpr std::array<Kind, 4> kinds{{{"C1", "c1", 6.17e-6, 1.78e-4},
                                     {"G1", "g1", 1.64e-6, 4.50e-5},
                                     {"C2", "c2", 6.24e-5, 1.12e-3},
                                     {"G2", "g2", 3.23e-5, 7.75e-4}}};
struct Sort {
  std::string_view words, mode;
  bool closed;
  int curves;
};
constexpr std::array<Sort, 3> sorts{{{"open, local", "local", false, 40},
                                     {"closed, global", "global", true, 16},
                                     {"closed, local", "local", true, 12}}};
/// Chords that differ up to a thousand times: C2 alone, because they take long.
constexpr Sort uneven{"open, local, uneven", "local", false, 8};
/// Those that the paper recommends: open curves window by window, closed ones all at once.
constexpr std::array usual_sorts{sorts[0], sorts[1]};

std::string label_of(const Kind& kind, const Sort& sort) { return fmt::format("{}, {}", kind.words, sort.words); }

// ---- what is measured

constexpr int points = 10;
constexpr std::string_view shown = "duck";
const Quantity was_solved = study::count_of("solved"), segments = study::count_of("segments"),
               missed = study::count_of("missed joints"), scaled_energy{"mean E", "1", Method::sampled},
               few_intervals{"segments_with_at_most_two_intervals", "1", Method::exact},
               offset{"extremum_offset_mean", "chords", Method::sampled};

double metric_of(std::string_view metric, const Quantity& column, const Scheme& scheme, const Fit& fit) {
  for (const Measurement& m : find_metric(metric).measure(scheme, fit))
    if (m.column == column.name) return m.value;
  return undefined;
}

void measure(const Scheme& scheme, const Input& input, int index, Notes& notes) {
  const Fit fit = scheme.fit(input);
  const bool solved = study::solved(fit);
  notes.row({curve_number(index)},
            {was_solved(solved ? 1 : 0), scaled_energy(mean_energy_of(fit) * mean_chord(input))});
  if (!solved) return;
  const auto jumps = joint_jumps(*fit.curve, input);
  notes.row({curve_number(index)},
            {missed(std::ranges::count_if(jumps, [](const JointJump& jump) { return !jump.meets_claim; })),
             few_intervals(metric_of("monotone_intervals", few_intervals, scheme, fit)),
             offset(metric_of("extremum_offset", offset, scheme, fit)), segments(fit.curve->size())});
}

void measure_usual(const Uses& uses, Notes& notes) {
  const bool closed = uses.words.at("curves") == "closed";
  for (int i = 0; i < uses.numbers.at("inputs"); ++i)
    measure(*uses.schemes.front(), random_curve(uses.seed, i, points, closed), i, notes);
}

void measure_uneven(const Uses& uses, Notes& notes) {
  for (int i = 0; i < uses.numbers.at("inputs"); ++i)
    measure(*uses.schemes.front(),
            random_input(RandomKind::uneven, points, uses.seed + static_cast<std::uint64_t>(i), false), i, notes);
}

Uses uses_of(const Context& context, const Kind& kind, const Sort& sort) {
  return {.work = "continuity of random curves",
          .version = 2,
          .schemes = {pkappa(context.registry, fmt::format("continuity={},mode={}", kind.option, sort.mode))},
          .metrics = {&find_metric("parabola_energy"), &find_metric("continuity"), &find_metric("monotone_intervals"),
                      &find_metric("extremum_offset")},
          .seed = context.seed,
          .numbers = {{"inputs", sort.curves}},
          .words = {{"curves", sort.closed ? "closed" : "open"}}};
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(kinds.size() * (1 + sorts.size()));
  for (const Kind& kind : kinds)
    jobs.push_back(fit_job(drawing(shown), pkappa(context.registry, fmt::format("continuity={}", kind.option)),
                           {&find_metric("parabola_energy"), &find_metric("continuity")}, std::string(kind.words)));
  for (const Sort& sort : sorts)
    for (const Kind& kind : kinds)
      jobs.push_back(study::numbers_job<measure_usual>(uses_of(context, kind, sort),
                                                       fmt::format("random, {} points, seed {}", points, context.seed),
                                                       label_of(kind, sort)));
  jobs.push_back(study::numbers_job<measure_uneven>(
      uses_of(context, kinds[2], uneven), fmt::format("random:uneven, {} points, seed {}", points, context.seed),
      label_of(kinds[2], uneven)));
  return jobs;
}

// ---- what follows

Rows rows_of(const Findings& found, const Kind& kind, const Sort& sort) {
  return found.rows().where({study::key::label(label_of(kind, sort))});
}

/// Segments with at most two intervals.
Tally few_of(const Rows& rows) {
  Tally tally;
  for (const study::Row* row : rows)
    if (row->has(few_intervals))
      tally += {.agree = (*row)[few_intervals] * (*row)[segments], .cases = (*row)[segments]};
  return tally;
}

Table random_table(const Findings& found) {
  /// Mean E_p times mean chord, from a turn so tight that the quadrature of the energy misses it.
  constexpr double tight = 1.0;
  Table table("random", "Random curves by continuity",
              fmt::format("Random curves of {} points (walks, stars, zigzags, spirals). "
                          "Median over the solved curves of mean E_p times mean chord; share of all "
                          "segments with at most two intervals of monotone curvature; median over curves of the "
                          "mean distance from a point to the nearest extremum of curvature over the chord; "
                          "joints that miss their continuity. Uneven: {} curves whose chords differ up to a "
                          "thousand times. Tight: solved curves whose mean E_p times mean chord is "
                          "above {:g}, from a turn so tight that the quadrature of the energy misses it.",
                          points, uneven.curves, tight));
  table.words("continuity").words("curves").counts("tried").counts("solved").counts("tight");
  table.numbers("mean E, median").numbers("at most two intervals").numbers("offset of points").counts("missed joints");
  for (const Sort& sort : {sorts[0], sorts[1], sorts[2], uneven})
    for (const Kind& kind : kinds) {
      const Rows rows = rows_of(found, kind, sort);
      const std::vector<double> energies = rows.values(scaled_energy);
      if (energies.empty()) continue;
      table.row({kind.words, sort.words, energies.size(), rows.total(was_solved),
                 std::ranges::count_if(energies, [](double e) { return e > tight; }), rows.median(scaled_energy),
                 few_of(rows).share(), rows.median(offset), rows.total(missed)});
    }
  return table;
}

/// Mean and largest E_p over all segments of the drawing, and the joints that miss their continuity.
struct Drawn {
  double mean = 0.0, largest = 0.0, missed = 0.0;

  explicit Drawn(const store::CellRecord& cell) {
    double all = 0.0;
    for (const store::CurveRecord& curve : cell.curves) {
      const auto value = [&curve](const Column& column) { return measured(curve, column).value_or(undefined); };
      const double n = static_cast<double>(curve.point_x.size()) - (curve.closed ? 0.0 : 2.0);
      all += n;
      mean += n * value(column::parabola_energy_native.mean);
      largest = std::max(largest, value(column::parabola_energy_native.max));
      missed += value(column::continuity_violations);
    }
    mean /= all;
  }
};

Table drawing_table(const Findings& found) {
  Table table("figure-13", "Fig. 13 and a stand-in",
              "Mean and largest E_p as printed and of our drawing, in its units. The printed numbers of G1 are "
              "those that Table 2 gives for Fig. 11(e), which the text calls C1.");
  table.words("continuity").numbers("mean E, printed").numbers("mean E", "1/length");
  table.numbers("max E, printed").numbers("max E", "1/length").counts("missed joints");
  for (const Kind& kind : kinds)
    if (const auto cell = found.find(shown, kind.words)) {
      const Drawn ours(found.cell(*cell));
      table.row({kind.words, kind.mean, ours.mean, kind.largest, ours.largest, ours.missed});
    }
  return table;
}

void claim_held(Findings& found) {
  double joints = 0.0, curves = 0.0;
  for (const Sort& sort : sorts)
    for (const Kind& kind : kinds) {
      joints += rows_of(found, kind, sort).total(missed);
      curves += rows_of(found, kind, sort).total(was_solved);
    }
  found.by_construction("continuity-held",
                        {fmt::format("{:.0f} joints miss their continuity", joints),
                         fmt::format("All joints of {:.0f} random curves: C1, G1, C2 and G2, open and closed. A curve "
                                     "that missed its continuity would not count as solved.",
                                     curves)});
}

/// How often geometric joints have the lower energy, over the usual sorts of curves.
Tally geometric_lower(const Findings& found, const Kind& parametric, const Kind& geometric) {
  Tally lower;
  for (const Sort& sort : usual_sorts)
    lower += TwoWays(found.rows().pairs(scaled_energy, study::key::label(label_of(parametric, sort)),
                                        study::key::label(label_of(geometric, sort))))
                 .second_lower;
  return lower;
}

void claim_geometric(Findings& found) {
  const Tally first = geometric_lower(found, kinds[0], kinds[1]), second = geometric_lower(found, kinds[2], kinds[3]);
  Tally both = first;
  both += second;
  std::string drawn;
  for (const Kind& kind : kinds) {
    const auto cell = found.find(shown, kind.words);
    drawn += fmt::format("{}{} {:.2g}", drawn.empty() ? "" : ", ", kind.words,
                         cell ? Drawn(found.cell(*cell)).mean : undefined);
  }
  found.judge("geometric-lowers-energy", both,
              {fmt::format("G1 below C1 on {}, G2 below C2 on {}", first.words(), second.words()),
               fmt::format("Mean E_p of the random curves, open (local) and closed (global), where both are solved. On "
                           "the stand-in for Fig. 13: {}. The paper says that more freedom often enables lower energy.",
                           drawn)});
}

void claim_intervals(Findings& found) {
  Tally all;
  std::string each;
  for (const Sort& sort : usual_sorts)
    for (const Kind& kind : kinds) {
      const Tally few = few_of(rows_of(found, kind, sort));
      all += few;
      each += fmt::format("{}{} {:.1f} %", each.empty() ? "" : ", ", label_of(kind, sort),
                          100.0 * few.agree / std::max(1.0, few.cases));
    }
  found.judge("two-intervals", all,
              {fmt::format("{} segments", all.words()),
               fmt::format("Random curves, exact isolation of the extrema of curvature: {}.", each)});
}

void claim_extrema(Findings& found) {
  // "Approximately" is taken as: within a tenth of the chord along the curve, on average over a curve's points.
  constexpr double near = 0.1;
  Tally all;
  std::vector<double> offsets;
  for (const Sort& sort : usual_sorts)
    for (const Kind& kind : kinds)
      for (const double value : rows_of(found, kind, sort).values(offset)) {
        all.add(value <= near);
        offsets.push_back(value);
      }
  found.judge(
      "points-near-extrema", all,
      {fmt::format("within {:g} chords on average on {} curves; median {:.2g}", near, all.words(), median(offsets)),
       "Arc length from each point to the nearest extremum of curvature over the local chord, mean over the "
       "points of a random curve."});
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "pkappa-continuity",
                             .title = "Four kinds of joints",
                             .caption =
                                 "The same points with C1, G1, C2 and G2 joints and their combs: the combs of the "
                                 "upper row jump at joints, those of the lower row do not. Stand-in for Fig. 13.",
                             .columns = 2,
                             .panels = {}};
  for (const Kind& kind : kinds)
    if (const auto cell = found.find(shown, kind.words))
      figure.panels.push_back(Panel::curves({*cell}, std::string(kind.words)).comb().without_points());
  return figure;
}

void conclude(Findings& found) {
  found.add(drawing_table(found));
  found.add(random_table(found));
  claim_held(found);
  claim_geometric(found);
  claim_intervals(found);
  claim_extrema(found);
  found.add(figure(found));
}

}  // namespace

Experiment pkappa_continuity_experiment() {
  return study::experiment(
      {.id = "pkappa-continuity",
       .title = "Four kinds of continuity (Wang 2024, Fig. 13)",
       .about = std::string(about),
       .paper = std::string(paper),
       .claims = {"continuity-held", "geometric-lowers-energy", "two-intervals", "points-near-extrema"},
       .jobs = jobs,
       .conclude = conclude});
}

}  // namespace kappabench
