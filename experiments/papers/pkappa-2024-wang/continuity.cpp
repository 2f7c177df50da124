#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "datasets/random_points.hpp"
#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {

using namespace wang;

namespace {

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

constexpr std::string_view shown = "duck";
constexpr int version = 2, points = 10;
constexpr double tight = 1.0;
constexpr Sort uneven{"open, local, uneven", "local", false, 8};

std::string label_of_sweep(const Kind& kind, const Sort& sort) { return fmt::format("{}, {}", kind.words, sort.words); }

void measure(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  const auto put = [&cell](std::string column, double value, Method method) {
    study::put(cell, std::move(column), value, method);
  };
  const Fit fit = scheme.fit(input);
  const bool solved = study::solved(fit);
  put("solved", solved ? 1.0 : 0.0, Method::exact);
  // One value a curve in every column, so that curves can be compared across cells.
  const double nothing = std::nan("");
  put("mean E", solved ? mean(parabola_energies(*fit.curve)) * mean_chord(input) : nothing, Method::sampled);
  if (!solved) return;
  double missed = 0.0;
  for (const JointJump& jump : joint_jumps(*fit.curve, mean_chord(input))) missed += jump.meets_claim() ? 0.0 : 1.0;
  put("missed joints", missed, Method::exact);
  for (const Metric* metric : {&find_metric("monotone_intervals"), &find_metric("extremum_offset")})
    for (const Measurement& m : metric->measure(scheme, fit))
      if (m.column == "segments_with_at_most_two_intervals" || m.column == "extremum_offset_mean")
        put(m.column, m.value, m.method);
  put("segments", fit.curve->size(), Method::exact);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Drawing points_of = drawing(shown);
  const std::vector<const Metric*> metrics{&find_metric("parabola_energy"), &find_metric("continuity")};
  for (const Kind& kind : kinds) {
    jobs.push_back(fit_job(points_of, pkappa(context.registry, fmt::format("continuity={}", kind.option)), metrics));
    jobs.back().label = kind.words;
  }
  const std::uint64_t seed = context.seed;
  for (const Sort& sort : sorts)
    for (const Kind& kind : kinds) {
      const SchemePtr scheme = pkappa(context.registry, fmt::format("continuity={},mode={}", kind.option, sort.mode));
      jobs.push_back(sweep_job(fmt::format("random, {} points, seed {}", points, seed), scheme,
                               label_of_sweep(kind, sort), version, sort.curves,
                               [scheme, seed, closed = sort.closed](int index, store::CellRecord& cell) {
                                 measure(*scheme, random_curve(seed, index, points, closed), cell);
                               }));
    }
  // Chords that differ up to a thousand times: C2 alone, because they take long.
  const SchemePtr scheme = pkappa(context.registry, "");
  jobs.push_back(sweep_job(fmt::format("random:uneven, {} points, seed {}", points, seed), scheme,
                           label_of_sweep(kinds[2], uneven), version, uneven.curves,
                           [scheme, seed](int index, store::CellRecord& cell) {
                             const auto own = seed + static_cast<std::uint64_t>(index);
                             measure(*scheme, random_input(RandomKind::uneven, points, own, false), cell);
                           }));
  return jobs;
}

std::vector<double> column_of(const store::ExperimentRecord& record, const Kind& kind, const Sort& sort,
                              std::string_view column) {
  std::vector<double> all;
  for (const int c : cells_labelled(record, label_of_sweep(kind, sort)))
    for (const store::MeasurementRecord& m : record.cells[static_cast<std::size_t>(c)].measurements)
      if (m.column == column) all.push_back(m.value);
  return all;
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double v : values) total += v;
  return total;
}

/// Segments with at most two intervals.
Tally few_intervals(const store::ExperimentRecord& record, const Kind& kind, const Sort& sort) {
  const auto shares = column_of(record, kind, sort, "segments_with_at_most_two_intervals");
  const auto segments = column_of(record, kind, sort, "segments");
  Tally tally;
  for (std::size_t i = 0; i < std::min(shares.size(), segments.size()); ++i) {
    tally.cases += segments[i];
    tally.agree += shares[i] * segments[i];
  }
  return tally;
}

store::TableRecord random_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "random", "Random curves by continuity",
      fmt::format("Random curves of {} points (walks, stars, zigzags, spirals). "
                  "Median over the solved curves of mean E_p times mean chord; share of all "
                  "segments with at most two intervals of monotone curvature; median over curves of the "
                  "mean distance from a point to the nearest extremum of curvature over the chord; "
                  "joints that miss their continuity. Uneven: {} curves whose chords differ up to a "
                  "thousand times. Tight: solved curves whose mean E_p times mean chord is "
                  "above {:g}, from a turn so tight that the quadrature of the energy misses it.",
                  points, uneven.curves, tight));
  builder.words("continuity")
      .words("curves")
      .counts("tried")
      .counts("solved")
      .counts("tight")
      .numbers("mean E, median");
  builder.numbers("at most two intervals").numbers("offset of points").counts("missed joints");
  for (const Sort& sort : {sorts[0], sorts[1], sorts[2], uneven})
    for (const Kind& kind : kinds)
      if (const auto solved = column_of(record, kind, sort, "solved"); !solved.empty()) {
        const auto energies = column_of(record, kind, sort, "mean E");
        const Tally few = few_intervals(record, kind, sort);
        const auto is_tight = [](double e) { return e > tight; };
        builder.row({std::string(kind.words), std::string(sort.words), static_cast<double>(solved.size()), sum(solved),
                     static_cast<double>(std::ranges::count_if(energies, is_tight)), median(energies),
                     few.agree / few.cases, median(column_of(record, kind, sort, "extremum_offset_mean")),
                     sum(column_of(record, kind, sort, "missed joints"))});
      }
  return builder.table();
}

/// Mean and largest E_p over all segments of the drawing.
struct Energy {
  int cell = -1;
  double mean = 0.0, largest = 0.0;
};

Energy energy_of(const store::ExperimentRecord& record, const Kind& kind) {
  Energy energy;
  const auto cell = study::drawn_cell(record, shown, kind.words);
  if (!cell) return energy;
  energy.cell = *cell;
  double segments = 0.0;
  for (const store::CurveRecord& curve : record.cells[static_cast<std::size_t>(*cell)].curves) {
    const double n = static_cast<double>(curve.point_x.size()) - (curve.closed ? 0.0 : 2.0);
    segments += n;
    energy.mean += n * measured(curve, "parabola_energy_native_mean").value_or(std::nan(""));
    energy.largest = std::max(energy.largest, measured(curve, "parabola_energy_native_max").value_or(std::nan("")));
  }
  energy.mean /= segments;
  return energy;
}

store::TableRecord drawing_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "figure-13", "Fig. 13 and a stand-in",
      "Mean and largest E_p as printed and of our drawing, in its units. The printed numbers of G1 are "
      "those that Table 2 gives for Fig. 11(e), which the text calls C1.");
  builder.words("continuity").numbers("mean E, printed").numbers("mean E", "1/length");
  builder.numbers("max E, printed").numbers("max E", "1/length").counts("missed joints");
  for (const Kind& kind : kinds)
    if (const Energy energy = energy_of(record, kind); energy.cell >= 0) {
      double missed = 0.0;
      for (const store::CurveRecord& curve : record.cells[static_cast<std::size_t>(energy.cell)].curves)
        missed += measured(curve, "continuity_violations").value_or(std::nan(""));
      builder.row({std::string(kind.words), kind.mean, energy.mean, kind.largest, energy.largest, missed});
    }
  return builder.table();
}

store::ClaimRecord held_claim(const store::ExperimentRecord& record) {
  double missed = 0.0, solved = 0.0;
  for (const Sort& sort : sorts)
    for (const Kind& kind : kinds) {
      missed += sum(column_of(record, kind, sort, "missed joints"));
      solved += sum(column_of(record, kind, sort, "solved"));
    }
  return claim("continuity-held", study::verdict_for_all(missed, solved),
               fmt::format("{:.0f} joints miss their continuity", missed),
               fmt::format("All joints of {:.0f} random curves: C1, G1, C2 and G2, open and closed.", solved));
}

store::ClaimRecord geometric_claim(const store::ExperimentRecord& record) {
  Tally first, second;
  for (const Sort& sort : {sorts[0], sorts[1]})
    for (const auto& [c, g, tally] : {std::tuple(0, 1, &first), std::tuple(2, 3, &second)}) {
      const auto parametric = column_of(record, kinds[static_cast<std::size_t>(c)], sort, "mean E");
      const auto geometric = column_of(record, kinds[static_cast<std::size_t>(g)], sort, "mean E");
      for (std::size_t i = 0; i < std::min(parametric.size(), geometric.size()); ++i)
        if (std::isfinite(parametric[i]) && std::isfinite(geometric[i])) tally->add(geometric[i] < parametric[i]);
    }
  std::array<double, 4> drawn{};
  for (std::size_t k = 0; k < kinds.size(); ++k) drawn[k] = energy_of(record, kinds[k]).mean;
  return claim("geometric-lowers-energy",
               verdict_often({.agree = first.agree + second.agree, .cases = first.cases + second.cases}),
               fmt::format("G1 below C1 on {}, G2 below C2 on {}", study::share(first.agree, first.cases),
                           study::share(second.agree, second.cases)),
               fmt::format("Mean E_p of the random curves, open (local) and closed (global), where both are solved. On "
                           "the stand-in for Fig. 13: C1 {:.2g}, G1 {:.2g}, C2 {:.2g}, G2 {:.2g}. The paper says that "
                           "more freedom often enables lower energy.",
                           drawn[0], drawn[1], drawn[2], drawn[3]));
}

store::ClaimRecord intervals_claim(const store::ExperimentRecord& record) {
  Tally all;
  std::string each;
  for (const Sort& sort : {sorts[0], sorts[1]})
    for (const Kind& kind : kinds) {
      const Tally tally = few_intervals(record, kind, sort);
      all.agree += tally.agree;
      all.cases += tally.cases;
      each += fmt::format("{}{} {:.1f} %", each.empty() ? "" : ", ", label_of_sweep(kind, sort),
                          100.0 * tally.agree / std::max(1.0, tally.cases));
    }
  return claim("two-intervals", verdict_often(all), fmt::format("{} segments", study::share(all.agree, all.cases)),
               fmt::format("Random curves, exact isolation of the extrema of curvature: {}.", each));
}

store::ClaimRecord extrema_claim(const store::ExperimentRecord& record) {
  // "Approximately" is taken as: within a tenth of the chord along the curve, on average over a curve's points.
  constexpr double near = 0.1;
  Tally all;
  std::vector<double> offsets;
  for (const Sort& sort : {sorts[0], sorts[1]})
    for (const Kind& kind : kinds)
      for (const double offset : column_of(record, kind, sort, "extremum_offset_mean")) {
        all.add(offset <= near);
        offsets.push_back(offset);
      }
  return claim("points-near-extrema", study::verdict_in_general(all.agree, all.cases),
               fmt::format("within {:g} chords on average on {} curves; median {:.2g}", near,
                           study::share(all.agree, all.cases), median(offsets)),
               "Arc length from each point to the nearest extremum of curvature over the local chord, mean over the "
               "points of a random curve.");
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "pkappa-continuity",
                             .title = "Four kinds of joints",
                             .caption =
                                 "The same points with C1, G1, C2 and G2 joints and their combs: the combs of the "
                                 "upper row jump at joints, those of the lower row do not. Stand-in for Fig. 13.",
                             .columns = 2,
                             .panels = {}};
  for (const Kind& kind : kinds)
    if (const auto cell = study::drawn_cell(record, shown, kind.words)) {
      figure.panels.push_back(curve_panel({*cell}, std::string(kind.words), true));
      figure.panels.back().points = false;
    }
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {drawing_table(record), random_table(record)};
  record.claims = {held_claim(record), geometric_claim(record), intervals_claim(record), extrema_claim(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
}

}  // namespace

Experiment pkappa_continuity_experiment() {
  return {.id = "pkappa-continuity",
          .title = "Four kinds of continuity (Wang 2024, Fig. 13)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
