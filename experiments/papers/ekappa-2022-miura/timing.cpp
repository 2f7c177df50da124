// Miura 2022, Sect. 5: how long do the three bases take to draw the bear?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "datasets/datasets.hpp"
#include "datasets/random_source.hpp"
#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/timing.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Key, study::Notes, study::Quantity, study::Table;

constexpr std::string_view about =
    "The paper gives times for drawing its bear: 0.07 s with kappa-curves, 0.08 s with the cubic basis, 0.37 s with "
    "the trigonometric one, on a machine and with a number of samples that it does not name. Here a bear drawn for "
    "this program is fitted, and fitted and drawn (100 positions a segment), by each basis with the published "
    "iteration at its usual 50 steps and with the Newton cascade. All are timed in one process, samples in random "
    "order, by Google Benchmark, in processor time; only ratios to the kappa-curve's median are compared. When several "
    "cells run at once, or the machine is busy, the samples scatter more: the interval of each ratio (95 %, bootstrap "
    "over the samples) shows it.";

/// What Section 5 times.
struct Timed {
  std::string_view title;
  std::string_view scheme;
};
constexpr std::array<Timed, 3> timed{{{"kappa", "kappa"},
                                      {"cubic Bernstein, a = 0.85", "ekappa:a=0.85"},
                                      {"trigonometric, a = 0.75", "ekappa-trig:a=0.75"}}};
struct Solver {
  std::string_view title;
  std::string_view parameters;
};
constexpr std::array<Solver, 2> solvers{
    {{"published", "iteration=published,max_iterations=50"}, {"Newton", "iteration=newton"}}};

SchemePtr scheme_of(const Registry& registry, const Timed& curve, const Solver& solver) {
  const bool has_parameters = curve.scheme.find(':') != std::string_view::npos;
  return registry.parse(fmt::format("{}{}{}", curve.scheme, has_parameters ? ',' : ':', solver.parameters));
}

constexpr std::array<std::string_view, 2> tasks{"fit", "fit and draw"};
std::string name_of(std::string_view task, const Timed& curve, const Solver& solver) {
  return fmt::format("{}: {}, {}", task, curve.title, solver.title);
}

// ---- what is measured: CellRecord::timings by name_of, and a row each

constexpr int positions_per_segment = 100;
const Key work_key{"work"};
const Quantity steps = study::count_of("steps");

/// Fits all curves, and draws them if the task is to; returns the steps taken.
int work_on(const Drawing& drawing, const Scheme& scheme, std::string_view task) {
  int taken = 0;
  for (const Input& input : drawing.curves) {
    const Fit fit = scheme.fit(input);
    taken += fit.report.iterations;
    if (task == tasks[1] && fit.curve) (void)sample(*fit.curve, positions_per_segment, 0);
  }
  return taken;
}

/// The schemes: every curve by the first solver, then by the second.
void measure(const Uses& uses, Notes& notes) {
  const Drawing& drawing = uses.drawings.front();
  std::vector<TimedWork> works;
  for (std::size_t i = 0; i < uses.schemes.size(); ++i)
    for (const std::string_view task : tasks) {
      const Scheme& scheme = *uses.schemes[i];
      const std::string name = name_of(task, timed[i % timed.size()], solvers[i / timed.size()]);
      notes.row({work_key(name)}, {steps(work_on(drawing, scheme, task))});
      works.push_back({name, [&drawing, &scheme, task] { (void)work_on(drawing, scheme, task); }});
    }
  notes.cell().timings = time_all(works, {.repetitions = 12, .least_seconds = 0.01});
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<SchemePtr> schemes;
  for (const Solver& solver : solvers)
    for (const Timed& curve : timed) schemes.push_back(scheme_of(context.registry, curve, solver));
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : study::without_options(study::drawings_or(context, {"bear"})))
    jobs.push_back(
        study::numbers_job<measure>({.work = "timing of three bases", .schemes = schemes, .drawings = {drawing}},
                                    drawing.id, "three bases, two solvers"));
  return jobs;
}

// ---- what follows

/// A ratio of medians with the middle 95 % of what resampled samples give.
struct Ratio {
  double value, low, high;
};

Ratio ratio_of_medians(const std::vector<double>& above, const std::vector<double>& below) {
  constexpr int resamples = 2000;
  RandomSource random(41);
  const auto resampled = [&random](const std::vector<double>& from) {
    std::vector<double> drawn(from.size());
    for (double& d : drawn) d = from[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(from.size())))];
    return median(std::move(drawn));
  };
  std::vector<double> ratios(resamples);
  for (double& r : ratios) {
    const double numerator = resampled(above);
    r = numerator / resampled(below);
  }
  std::ranges::sort(ratios);
  return {median(above) / median(below), ratios[resamples / 40], ratios[resamples - 1 - resamples / 40]};
}

const std::vector<double>& samples(const store::CellRecord& cell, const std::string& key) {
  static const std::vector<double> none;
  const auto found = cell.timings.find(key);
  return found == cell.timings.end() ? none : found->second;
}

Ratio ratio_to_kappa(const store::CellRecord& cell, std::string_view task, const Timed& curve, const Solver& solver) {
  return ratio_of_medians(samples(cell, name_of(task, curve, solver)), samples(cell, name_of(task, timed[0], solver)));
}

Table time_table(const Findings& found) {
  Table table("timing", "Time to fit, and to fit and draw",
              "Medians and quartiles of the samples; ratio of medians to the kappa-curve with the same solver "
              "and task, with its 95 % interval. The paper's ratios are 1.14 and 5.29.");
  table.words("drawing").words("task").words("solver").words("curve").counts("steps");
  table.numbers("median", "ms").numbers("lower quartile", "ms").numbers("upper quartile", "ms").counts("samples");
  table.numbers("ratio to kappa").numbers("ratio, low").numbers("ratio, high");
  for (const store::CellRecord& cell : found.cells())
    for (const std::string_view task : tasks)
      for (const Solver& solver : solvers)
        for (const Timed& curve : timed) {
          const std::string name = name_of(task, curve, solver);
          const std::vector<double>& own = samples(cell, name);
          if (own.empty() || samples(cell, name_of(task, timed[0], solver)).empty()) continue;
          const Ratio ratio = ratio_to_kappa(cell, task, curve, solver);
          const auto rows = found.rows().where({study::key::dataset(cell.dataset), work_key(name)});
          table.row({cell.dataset, task, solver.title, curve.title, rows.total(steps), 1e3 * median(own),
                     1e3 * quantile(own, 0.25), 1e3 * quantile(own, 0.75), own.size(), ratio.value, ratio.low,
                     ratio.high});
        }
  return table;
}

/// Section 5 tells of the published iteration.
void claim_time(Findings& found, const store::CellRecord& cell, std::string_view id, const Timed& curve) {
  const std::string_view task = tasks[1];
  const auto milliseconds = [&](const Timed& of) { return 1e3 * median(samples(cell, name_of(task, of, solvers[0]))); };
  const Ratio published = ratio_to_kappa(cell, task, curve, solvers[0]);
  const Ratio newton = ratio_to_kappa(cell, task, curve, solvers[1]);
  found.judge(
      id, study::Interval{published.low, published.high},
      {fmt::format("{:.3g} ms : {:.3g} ms, ratio {:.3g} ({:.3g} to {:.3g})", milliseconds(curve),
                   milliseconds(timed[0]), published.value, published.low, published.high),
       fmt::format("Fitting and drawing '{}' with the published iteration of 50 steps. With the Newton cascade "
                   "the ratio is {:.3g} ({:.3g} to {:.3g}). Here the kappa-curve runs through the solver of the "
                   "cubic basis.",
                   cell.dataset, newton.value, newton.low, newton.high)});
}

void conclude(Findings& found) {
  found.add(time_table(found));
  const auto cell = std::ranges::find_if(found.cells(), [](const auto& c) { return !c.timings.empty(); });
  if (cell == found.cells().end()) return;
  claim_time(found, *cell, "time-bernstein", timed[1]);
  claim_time(found, *cell, "time-trigonometric", timed[2]);
}

}  // namespace

Experiment ekappa_timing_experiment() {
  return study::experiment({.id = "ekappa-timing",
                            .title = "Time to draw the bear",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"time-bernstein", "time-trigonometric"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
