// Wang 2024, Figs. 11 and 12, Table 2: how near a parabola is curvature in whole drawings, and how long does it take?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/measured.hpp"
#include "metrics/monotone_intervals.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Panel, study::Table, study::Tally;

constexpr std::string_view about =
    "Six cartoons of C1 quartic curves and the profile of a car of C2 quintic ones, drawn for this program with the "
    "numbers of points and curves that Table 2 prints. Energies have units, and the paper's are unknown, so mean and "
    "largest E_p are given in the drawings' units and, free of scale, times the mean chord. The time is that of the "
    "whole construction over the number of points, on this machine.";

struct Printed {
  std::string_view dataset, place, options;
  double mean, largest, seconds;
};
constexpr std::array<Printed, 7> table_2{{{"owl", "Fig. 11(a)", "continuity=c1", 8.36e-5, 1.75e-3, 0.11},
                                          {"whale", "Fig. 11(b)", "continuity=c1", 1.78e-6, 1.74e-5, 0.15},
                                          {"goldfish", "Fig. 11(c)", "continuity=c1", 3.60e-4, 7.08e-3, 0.22},
                                          {"cat", "Fig. 11(d)", "continuity=c1", 1.28e-6, 2.13e-5, 0.16},
                                          {"duck", "Fig. 11(e)", "continuity=c1", 1.64e-6, 4.50e-5, 0.18},
                                          {"snail", "Fig. 11(f)", "continuity=c1", 4.26e-6, 1.14e-4, 0.23},
                                          {"car", "Fig. 12", "", 4.45e-5, 9.42e-4, 0.76}}};
constexpr std::string_view as_printed = "as printed", as_default = "pκ-curve";
/// The bounds of Sect. 6.2.
constexpr double energy_bound = 2.0e-3;

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<const Metric*> metrics{&find_metric("parabola_energy"), &find_metric("monotone_intervals"),
                                           &find_metric("extremum_offset")};
  std::vector<CellJob> jobs;
  for (const Printed& row : table_2)
    for (const auto& [mode, label] : {std::pair("", as_default), std::pair("mode=paper,", as_printed)})
      jobs.push_back(fit_job(drawing(row.dataset), pkappa(context.registry, fmt::format("{}{}", mode, row.options)),
                             metrics, std::string(label)));
  return jobs;
}

// ---- what follows

/// What Table 2 tells of a drawing: over all segments of all curves.
struct Statistics {
  int points = 0, open = 0, closed = 0, segments = 0, unsolved = 0;
  double mean = 0.0, scaled_mean = 0.0, seconds = 0.0, few_intervals = 0.0;
  double largest = 0.0, scaled_largest = 0.0;

  explicit Statistics(const store::CellRecord& cell) {
    for (const store::CurveRecord& curve : cell.curves) add(curve);
    for (double* sum : {&mean, &scaled_mean, &few_intervals}) *sum /= segments;
    seconds /= points;
  }

 private:
  void add(const store::CurveRecord& curve) {
    const int n = static_cast<int>(curve.point_x.size()), own_segments = curve.closed ? n : n - 2;
    const auto value = [&curve](const Column& column) {
      return measured(curve, column).value_or(std::numeric_limits<double>::infinity());
    };
    points += n;
    (curve.closed ? closed : open) += 1;
    unsolved += curve.outcome == "converged" ? 0 : 1;
    segments += own_segments;
    mean += own_segments * value(column::parabola_energy_native.mean);
    scaled_mean += own_segments * value(column::parabola_energy_native.scaled_mean);
    few_intervals += own_segments * measured(curve, column::segments_with_at_most_two_intervals).value_or(0.0);
    largest = std::max(largest, value(column::parabola_energy_native.max));
    scaled_largest = std::max(scaled_largest, value(column::parabola_energy_native.scaled_max));
    seconds += curve.seconds;
  }
};

Table table(const Findings& found) {
  Table table("table-2", "Table 2 and our drawings",
              "N_I points, N_O open and N_C closed curves; mean and largest E_p over the segments, printed, in "
              "the units of our drawings, and times the mean chord of each curve; seconds per point.");
  table.words("drawing").words("stands for").words("mode").counts("N_I").counts("N_O").counts("N_C");
  table.counts("unsolved").numbers("mean E, printed").numbers("mean E", "1/length").numbers("mean E, scaled");
  table.numbers("max E, printed").numbers("max E", "1/length").numbers("max E, scaled");
  table.numbers("T, printed", "s").numbers("T", "ms").numbers("at most two intervals");
  for (const Printed& row : table_2)
    for (const std::string_view label : {as_default, as_printed})
      if (const auto cell = found.find(row.dataset, label)) {
        const Statistics s(found.cell(*cell));
        table.row({row.dataset, row.place, label, s.points, s.open, s.closed, s.unsolved, row.mean, s.mean,
                   s.scaled_mean, row.largest, s.largest, s.scaled_largest, row.seconds, 1e3 * s.seconds,
                   s.few_intervals});
      }
  return table;
}

double worst(const Findings& found, std::string_view label, double Statistics::*what) {
  double largest = 0.0;
  for (const int cell : found.labelled(label)) largest = std::max(largest, Statistics(found.cell(cell)).*what);
  return largest;
}

/// The drawings in one mode whose energy is within the bound. A drawing with an unsolved curve has none.
Tally within_bound(const Findings& found, std::string_view label, double Statistics::*energy) {
  Tally within;
  for (const int cell : found.labelled(label)) {
    const Statistics s(found.cell(cell));
    within.add(s.unsolved == 0 && s.*energy <= energy_bound);
  }
  return within;
}

/// As printed, and our default mode beside it.
void claim_energy(Findings& found) {
  for (const auto& [label, method] : {std::pair(as_printed, "as printed"), std::pair(as_default, "our default mode")}) {
    const Tally own = within_bound(found, label, &Statistics::mean);
    const Tally scaled = within_bound(found, label, &Statistics::scaled_mean);
    found.judge("mean-energy-bound", own,
                {fmt::format("below on {}; the largest is {:.3g}", own.words(), worst(found, label, &Statistics::mean)),
                 fmt::format("Our drawings in their own units. Times the mean chord: {}.", scaled.words()), method});
  }
}

void claim_time(Findings& found) {
  const auto most_milliseconds = [&](std::string_view label) {
    return 1e3 * worst(found, label, &Statistics::seconds);
  };
  found.by_construction(
      "time-bound",
      {fmt::format("at most {:.2g} ms per point", most_milliseconds(as_default)),
       fmt::format("Default mode on this machine; windows as printed take at most {:.2g} ms. The paper "
                   "timed MATLAB's interior-point method on another machine: a thousand times as long, so "
                   "that compiled code stays below its bound whatever the method.",
                   most_milliseconds(as_printed))});
}

store::FigureRecord cartoons(const Findings& found) {
  store::FigureRecord figure{.id = "cartoons",
                             .title = "Cartoons of C1 quartic pκ-curves",
                             .caption = "Six drawings, stand-ins for Fig. 11.",
                             .columns = 3,
                             .panels = {}};
  for (const Printed& row : table_2)
    if (const auto cell = found.find(row.dataset, as_default); cell && row.dataset != "car")
      figure.panels.push_back(Panel::curves({*cell}, std::string(row.dataset)).without_joints());
  return figure;
}

store::FigureRecord car(const Findings& found) {
  store::FigureRecord figure{.id = "car",
                             .title = "The profile of a car of C2 quintic pκ-curves",
                             .caption = "141 points in 35 open curves, a stand-in for Fig. 12; below with combs.",
                             .columns = 1,
                             .panels = {}};
  if (const auto cell = found.find("car", as_default))
    figure.panels = {Panel::curves({*cell}, "points").without_joints(),
                     Panel::curves({*cell}, "combs").comb().without_joints().without_points()};
  return figure;
}

void conclude(Findings& found) {
  found.add(table(found));
  claim_energy(found);
  claim_time(found);
  found.add(cartoons(found));
  found.add(car(found));
}

}  // namespace

Experiment pkappa_gallery_experiment() {
  return study::experiment({.id = "pkappa-gallery",
                            .title = "Cartoons and a car (Wang 2024, Figs. 11 and 12, Table 2)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"mean-energy-bound", "time-bound"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
