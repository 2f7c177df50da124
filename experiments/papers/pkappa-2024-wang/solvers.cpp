// Wang 2024, Sections 5 and 6: which solver minimises a window, and what does it cost?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/papers/pkappa-2024-wang/two_ways.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/timing.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table;

constexpr std::string_view about =
    "The paper minimises each window by an interior-point method. Here every solver of this build constructs the same "
    "random open C2 curves, stage 1 alone, with windows made robust and as printed: how many curves are solved, the "
    "energy that stage 1 minimises (summed over the final curve, in units of the mean chord), and processor time per "
    "inserted point. Each curve is fitted by all solvers one after the other in one process, so that a busy machine "
    "hits all of them; only ratios compare. After the first insertions the windows start from each solver's own curve. "
    "Then both stages by Levenberg-Marquardt, window by window and the whole curve at once.";

/// A way to construct a curve: a solver and the windows that it is given.
struct Way {
  std::string solver, mode, stages;

  explicit Way(const Scheme& scheme)
      : solver(scheme.parameters().text("solver")),
        mode(scheme.parameters().text("mode")),
        stages(scheme.parameters().integer("stage2_iterations") == 0 ? "stage 1" : "both stages") {}
  [[nodiscard]] std::string words() const { return fmt::format("{}, {}, {}", solver, mode, stages); }
};
const std::string lm_stage_1 = "lm, local, stage 1", lm_both = "lm, local, both stages",
                  lm_at_once = "lm, global, both stages";

std::vector<SchemePtr> ways(const Registry& registry) {
  const SchemePtr defaults = pkappa(registry, "");
  const auto& parameters = defaults->info().parameters;
  const auto solver = std::ranges::find(parameters, "solver", &ParameterSpec::name);
  std::vector<SchemePtr> all;
  for (const std::string_view mode : {"local", "paper"})
    for (const std::string& each : solver->choices)
      all.push_back(pkappa(
          registry, fmt::format("mode={},solver={},stage2_iterations=0,unit=chord,quadrature=gauss", mode, each)));
  all.push_back(defaults);
  all.push_back(pkappa(registry, "mode=global"));
  return all;
}

// ---- what is measured

constexpr int points = 10, curves = 6;
/// Fits of the fast solvers are repeated, to be timed.
constexpr double least_seconds = 0.004;
constexpr int most_repetitions = 20;
const study::Key way_key{"way"}, counter_key{"counter"};
const Quantity energy{"energy", "1", Method::sampled}, mean_energy{"mean E", "1", Method::sampled},
    count = study::count_of("count");

void measure_curves(const Uses& uses, Notes& notes) {
  for (int i = 0; i < curves; ++i) {
    const Input input = random_curve(uses.seed, i, points, false);
    const double chord = mean_chord(input), inserted = points - 2;
    for (const SchemePtr& scheme : uses.schemes) {
      const std::string words = Way(*scheme).words();
      Fit fit;
      const double start = processor_seconds();
      double seconds = 0.0;
      int repetitions = 0;
      do {
        fit = scheme->fit(input);
        ++repetitions;
        seconds = processor_seconds() - start;
      } while (seconds < least_seconds && repetitions < most_repetitions);
      notes.cell().timings[words].push_back(seconds / repetitions / inserted);
      notes.row({curve_number(i), way_key(words)},
                {energy(study::solved(fit) ? first_stage_energy(*fit.curve, chord) / inserted : undefined),
                 mean_energy(mean_energy_of(fit) * chord)});
      for (const auto& [counter, n] : fit.report.counters)
        notes.row({curve_number(i), way_key(words), counter_key(counter)}, {count(n)});
    }
  }
}

std::vector<CellJob> jobs(const Context& context) {
  return {study::numbers_job<measure_curves>({.work = "solvers",
                                              .schemes = ways(context.registry),
                                              .metrics = {&find_metric("parabola_energy")},
                                              .seed = context.seed},
                                             fmt::format("random, {} points, seed {}", points, context.seed),
                                             "solvers")};
}

// ---- what follows

/// Processor seconds per inserted point, curve by curve.
std::vector<double> times(const Findings& found, const std::string& way) {
  std::vector<double> all;
  for (const store::CellRecord& cell : found.cells())
    if (const auto own = cell.timings.find(way); own != cell.timings.end())
      std::ranges::copy(own->second, std::back_inserter(all));
  return all;
}

TwoWays times_of(const Findings& found, const std::string& first, const std::string& second) {
  const std::vector<double> a = times(found, first), b = times(found, second);
  std::vector<study::Pair> pairs;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) pairs.emplace_back(a[i], b[i]);
  return TwoWays(pairs);
}

Table solver_table(const Findings& found) {
  Table table(
      "solvers", "What minimises a window",
      fmt::format("{} random open C2 curves of {} points, stage 1 alone. Energy: E_p + 0.1 E_e + 0.1 E_c "
                  "per segment with the mean chord as unit, median over solved curves, and median of its ratio to lm. "
                  "Lower, higher: "
                  "curves with a lower or higher energy than by lm in the same windows. Time: processor "
                  "time per inserted point; ratio: median over curves of the time over that of lm.",
                  curves, points));
  table.words("solver").words("windows").counts("curves").counts("solved").numbers("energy");
  table.numbers("energy over lm").counts("lower").counts("higher").numbers("time", "ms").numbers("ratio to lm");
  for (const SchemePtr& scheme : ways(found.context().registry)) {
    const Way way(*scheme);
    const std::string words = way.words(), lm = fmt::format("lm, {}, stage 1", way.mode);
    const std::vector<double> energies = found.rows().where({way_key(words)}).values(energy);
    if (way.stages != "stage 1" || energies.empty()) continue;
    const TwoWays against(found.rows().pairs(energy, way_key(words), way_key(lm)), 1e-6);
    table.row({way.solver, way.mode == "paper" ? "as printed" : "robust", energies.size(),
               std::ranges::count_if(energies, [](double e) { return !std::isnan(e); }), median(energies),
               median(against.ratios), against.first_lower.agree, against.second_lower.agree,
               1e3 * median(times(found, words)), median(times_of(found, words, lm).ratios)});
  }
  return table;
}

Table whole_table(const Findings& found) {
  Table table("whole", "Window by window and all at once",
              "The same curves by Levenberg-Marquardt: processor time per inserted point, median of mean E_p "
              "times mean chord.");
  table.words("construction").numbers("time", "ms").numbers("mean E");
  for (const std::string& words : {lm_stage_1, lm_both, lm_at_once})
    if (const auto own = times(found, words); !own.empty())
      table.row({words, 1e3 * median(own), found.rows().where({way_key(words)}).median(mean_energy)});
  return table;
}

Table counter_table(const Findings& found) {
  Table table("windows", "Windows of the construction",
              "Counted over all curves, Levenberg-Marquardt: windows solved; those that needed more than the "
              "usual starts, were widened, kept stage 1, failed verification, met the iteration limit.");
  table.words("construction");
  constexpr std::array<std::string_view, 6> counters{"windows",         "fallbacks",       "widened",
                                                     "stage2_reverted", "unsound_windows", "iteration_limit"};
  for (const std::string_view counter : counters) table.counts(std::string(counter));
  for (const std::string& words : {lm_stage_1, std::string("lm, paper, stage 1"), lm_both}) {
    std::vector<study::TableValue> row{words};
    for (const std::string_view counter : counters)
      row.emplace_back(found.rows().where({way_key(words), counter_key(counter)}).total(count));
    if (!times(found, words).empty()) table.row(row);
  }
  return table;
}

void claim_cost(Findings& found) {
  const TwoWays both = times_of(found, lm_at_once, lm_both);
  // Section 5.1 speaks of an edit: it costs one window, of as many as there are points, or the whole curve again.
  std::vector<double> of_an_edit = both.ratios;
  for (double& ratio : of_an_edit) ratio *= points;
  found.judge(
      "global-costs-more", study::interval_of_median(of_an_edit),
      {fmt::format("an edit takes {:.3g} times as long (median)", median(of_an_edit)),
       fmt::format("Processor time of both stages, random curves of {} points inserted one by one, or solved at "
                   "once with a block tridiagonal system. A whole curve "
                   "at once takes {:.2g} times as long as all its insertions.",
                   points, median(both.ratios))});
}

store::FigureRecord figure() {
  const auto by_solver = [](std::string column, std::string title, std::string y_label) {
    return Panel::graph("solvers", "solver", {std::move(column)}, std::move(title))
        .series("windows")
        .labels("", std::move(y_label))
        .dots();
  };
  return {.id = "pkappa-solvers",
          .title = "Four solvers",
          .caption =
              "Processor time, curves solved and energy after stage 1 by solver, with windows made robust and as "
              "printed.",
          .columns = 3,
          .panels = {by_solver("time", "time per inserted point", "ms").log_y(),
                     by_solver("solved", "curves solved", "curves"),
                     by_solver("energy", "energy after stage 1", "median energy")}};
}

void conclude(Findings& found) {
  found.add(solver_table(found));
  found.add(whole_table(found));
  found.add(counter_table(found));
  claim_cost(found);
  if (!found.cells().empty()) found.add(figure());
}

}  // namespace

Experiment pkappa_solvers_experiment() {
  return study::experiment({.id = "pkappa-solvers",
                            .title = "Solvers of the windows (Wang 2024, Sections 5 and 6)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"global-costs-more"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
