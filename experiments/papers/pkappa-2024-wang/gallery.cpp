#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "Six cartoons of C1 quartic curves and the profile of a car of C2 quintic ones, drawn for this program with the "
    "numbers of points and curves that Table 2 prints. Energies have units, and the paper's are unknown, so mean and "
    "largest E_p are given in the drawings' units and, free of scale, times the mean chord. The time is that of the "
    "whole construction over the number of points, on this machine.";

struct Row {
  std::string_view dataset, place, options;
  int points, open, closed;
  double mean, largest, seconds;  ///< printed
};
constexpr std::array<Row, 7> rows{{{"owl", "Fig. 11(a)", "continuity=c1", 78, 18, 1, 8.36e-5, 1.75e-3, 0.11},
                                   {"whale", "Fig. 11(b)", "continuity=c1", 43, 11, 0, 1.78e-6, 1.74e-5, 0.15},
                                   {"goldfish", "Fig. 11(c)", "continuity=c1", 59, 10, 0, 3.60e-4, 7.08e-3, 0.22},
                                   {"cat", "Fig. 11(d)", "continuity=c1", 52, 10, 0, 1.28e-6, 2.13e-5, 0.16},
                                   {"duck", "Fig. 11(e)", "continuity=c1", 59, 11, 0, 1.64e-6, 4.50e-5, 0.18},
                                   {"snail", "Fig. 11(f)", "continuity=c1", 76, 11, 4, 4.26e-6, 1.14e-4, 0.23},
                                   {"car", "Fig. 12", "", 141, 35, 0, 4.45e-5, 9.42e-4, 0.76}}};
constexpr std::string_view as_printed = "as printed", as_default = "pκ-curve";
/// The bounds of Sect. 6.2.
constexpr double energy_bound = 2.0e-3, time_bound = 0.83;

std::vector<CellJob> jobs(const Context& context) {
  const std::vector<const Metric*> metrics{&find_metric("parabola_energy"), &find_metric("monotone_intervals"),
                                           &find_metric("extremum_offset")};
  std::vector<CellJob> jobs;
  for (const Row& row : rows) {
    const Drawing points = drawing(row.dataset);
    jobs.push_back(fit_job(points, pkappa(context.registry, row.options), metrics));
    jobs.back().label = as_default;
    jobs.push_back(fit_job(points, pkappa(context.registry, fmt::format("mode=paper,{}", row.options)), metrics));
    jobs.back().label = as_printed;
  }
  return jobs;
}

/// What Table 2 tells of a drawing: over all segments of all curves.
struct Statistics {
  int cell = -1;
  int points = 0, open = 0, closed = 0, segments = 0, unsolved = 0;
  double mean = 0.0, scaled_mean = 0.0, seconds = 0.0, few_intervals = 0.0;
  double largest = 0.0, scaled_largest = 0.0;
};

Statistics statistics_of(const store::ExperimentRecord& record, const Row& row, std::string_view label) {
  Statistics s;
  const auto cell = study::drawn_cell(record, row.dataset, label);
  if (!cell) return s;
  s.cell = *cell;
  for (const store::CurveRecord& curve : record.cells[static_cast<std::size_t>(*cell)].curves) {
    const int n = static_cast<int>(curve.point_x.size()), segments = curve.closed ? n : n - 2;
    const auto value = [&curve](std::string_view column) {
      return measured(curve, column).value_or(std::numeric_limits<double>::infinity());
    };
    s.points += n;
    (curve.closed ? s.closed : s.open) += 1;
    s.unsolved += curve.outcome == "converged" ? 0 : 1;
    s.segments += segments;
    s.mean += segments * value("parabola_energy_native_mean");
    s.scaled_mean += segments * value("parabola_energy_native_scaled_mean");
    s.few_intervals += segments * measured(curve, "segments_with_at_most_two_intervals").value_or(0.0);
    s.largest = std::max(s.largest, value("parabola_energy_native_max"));
    s.scaled_largest = std::max(s.scaled_largest, value("parabola_energy_native_scaled_max"));
    s.seconds += curve.seconds;
  }
  s.mean /= s.segments;
  s.scaled_mean /= s.segments;
  s.seconds /= s.points;
  return s;
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "table-2", "Table 2 and our drawings",
      "N_I points, N_O open and N_C closed curves; mean and largest E_p over the segments, printed, in "
      "the units of our drawings, and times the mean chord of each curve; seconds per point.");
  builder.words("drawing").words("stands for").words("mode").counts("N_I").counts("N_O").counts("N_C");
  builder.counts("unsolved").numbers("mean E, printed").numbers("mean E", "1/length").numbers("mean E, scaled");
  builder.numbers("max E, printed").numbers("max E", "1/length").numbers("max E, scaled");
  builder.numbers("T, printed", "s").numbers("T", "ms").numbers("at most two intervals");
  for (const Row& row : rows)
    for (const std::string_view label : {as_default, as_printed})
      if (const Statistics s = statistics_of(record, row, label); s.cell >= 0)
        builder.row({std::string(row.dataset), std::string(row.place), std::string(label),
                     static_cast<double>(s.points), static_cast<double>(s.open), static_cast<double>(s.closed),
                     static_cast<double>(s.unsolved), row.mean, s.mean, s.scaled_mean, row.largest, s.largest,
                     s.scaled_largest, row.seconds, 1e3 * s.seconds, s.few_intervals / s.segments});
  return builder.table();
}

/// A statement about every drawing, for the default mode; the evidence tells of the other.
template <class Holds>
Tally tally_of(const store::ExperimentRecord& record, std::string_view label, const Holds& holds) {
  Tally tally;
  for (const Row& row : rows)
    if (const Statistics s = statistics_of(record, row, label); s.cell >= 0) tally.add(holds(s));
  return tally;
}

store::ClaimRecord energy_claim(const store::ExperimentRecord& record) {
  const auto below = [](const Statistics& s) { return s.unsolved == 0 && s.mean < energy_bound; };
  const auto scaled = [](const Statistics& s) { return s.unsolved == 0 && s.scaled_mean < energy_bound; };
  const Tally plain = tally_of(record, as_default, below), printed = tally_of(record, as_printed, below);
  const Tally free = tally_of(record, as_default, scaled);
  double worst = 0.0;
  for (const Row& row : rows) worst = std::max(worst, statistics_of(record, row, as_default).mean);
  return claim(
      "mean-energy-bound", study::verdict_for_all(plain.cases - plain.agree, plain.cases),
      fmt::format("below on {}; the largest is {:.3g}", study::share(plain.agree, plain.cases), worst),
      fmt::format("Our drawings in their own units, default mode. Windows as printed: {}. Times the mean chord, "
                  "default mode: {}.",
                  study::share(printed.agree, printed.cases), study::share(free.agree, free.cases)));
}

store::ClaimRecord time_claim(const store::ExperimentRecord& record) {
  const auto below = [](const Statistics& s) { return s.seconds <= time_bound; };
  const Tally plain = tally_of(record, as_default, below);
  double worst = 0.0, printed = 0.0;
  for (const Row& row : rows) {
    worst = std::max(worst, statistics_of(record, row, as_default).seconds);
    printed = std::max(printed, statistics_of(record, row, as_printed).seconds);
  }
  return claim("time-bound", study::verdict_for_all(plain.cases - plain.agree, plain.cases),
               fmt::format("at most {:.2g} ms per point", 1e3 * worst),
               fmt::format("Default mode on this machine; windows as printed take at most {:.2g} ms. The paper timed "
                           "MATLAB's interior-point method on another machine.",
                           1e3 * printed));
}

store::FigureRecord cartoons(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "cartoons",
                             .title = "Cartoons of C1 quartic pκ-curves",
                             .caption = "Six drawings, stand-ins for Fig. 11.",
                             .columns = 3,
                             .panels = {}};
  for (const Row& row : rows)
    if (const auto cell = study::drawn_cell(record, row.dataset, as_default); cell && row.dataset != "car") {
      figure.panels.push_back(curve_panel({*cell}, std::string(row.dataset), false));
      figure.panels.back().joints = false;
    }
  return figure;
}

store::FigureRecord car(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "car",
                             .title = "The profile of a car of C2 quintic pκ-curves",
                             .caption = "141 points in 35 open curves, a stand-in for Fig. 12; below with combs.",
                             .columns = 1,
                             .panels = {}};
  if (const auto cell = study::drawn_cell(record, "car", as_default)) {
    figure.panels.push_back(curve_panel({*cell}, "points", false));
    figure.panels.push_back(curve_panel({*cell}, "combs", true));
    for (store::PanelRecord& panel : figure.panels) panel.joints = false;
    figure.panels.back().points = false;
  }
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  record.claims = {energy_claim(record), time_claim(record)};
  for (store::FigureRecord& figure : std::array{cartoons(record), car(record)})
    if (!figure.panels.empty()) record.figures.push_back(std::move(figure));
}

}  // namespace

Experiment pkappa_gallery_experiment() {
  return {.id = "pkappa-gallery",
          .title = "Cartoons and a car (Wang 2024, Figs. 11 and 12, Table 2)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
