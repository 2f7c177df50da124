#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/timing.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "The paper minimises each window by an interior-point method. Here every solver of this build constructs the same "
    "random open C2 curves, stage 1 alone, with windows made robust and as printed: how many curves are solved, the "
    "energy that stage 1 minimises (summed over the final curve, in units of the mean chord), and processor time per "
    "inserted point. Each curve is fitted by all solvers one after the other in one process, so that a busy machine "
    "hits all of them; only ratios compare. After the first insertions the windows start from each solver's own curve. "
    "Then both stages by Levenberg-Marquardt, window by window and the whole curve at once.";

constexpr int version = 1, points = 10, curves = 6;
/// Fits of the fast solvers are repeated, to be timed.
constexpr double least_seconds = 0.004;
constexpr int most_repetitions = 20;
constexpr std::string_view label = "solvers";

struct Way {
  std::string words, solver, mode, options;
};

std::vector<std::string> solvers_of(const Registry& registry) {
  for (const SchemeInfo& info : registry.list())
    if (info.id == "pkappa")
      for (const ParameterSpec& spec : info.parameters)
        if (spec.name == "solver") return spec.choices;
  return {};
}

std::vector<Way> ways(const Registry& registry) {
  std::vector<Way> all;
  for (const std::string mode : {"local", "paper"})
    for (const std::string& solver : solvers_of(registry))
      all.push_back({fmt::format("{}, {}, stage 1", solver, mode), solver, mode,
                     fmt::format("mode={},solver={},stage2_iterations=0,unit=chord,quadrature=gauss", mode, solver)});
  all.push_back({"lm, local, both stages", "lm", "local", ""});
  all.push_back({"lm, global, both stages", "lm", "global", "mode=global"});
  return all;
}

void measure(const std::vector<std::pair<Way, SchemePtr>>& all, const Input& input, store::CellRecord& cell) {
  const double chord = mean_chord(input), inserted = input.size() - 2;
  for (const auto& [way, scheme] : all) {
    Fit fit;
    const double start = processor_seconds();
    double seconds = 0.0;
    int repetitions = 0;
    do {
      fit = scheme->fit(input);
      ++repetitions;
      seconds = processor_seconds() - start;
    } while (seconds < least_seconds && repetitions < most_repetitions);
    const bool solved = study::solved(fit);
    cell.timings[way.words].push_back(seconds / repetitions / inserted);
    study::put(cell, way.words + ": energy", solved ? first_stage_energy(*fit.curve, chord) / inserted : std::nan(""),
               Method::sampled);
    study::put(cell, way.words + ": mean E", solved ? mean(parabola_energies(*fit.curve)) * chord : std::nan(""),
               Method::sampled);
    for (const auto& [counter, count] : fit.report.counters)
      study::put(cell, fmt::format("{}: {}", way.words, counter), static_cast<double>(count));
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<std::pair<Way, SchemePtr>> all;
  std::string what;
  for (const Way& way : ways(context.registry)) {
    all.emplace_back(way, pkappa(context.registry, way.options));
    what += way.words + "; ";
  }
  const std::uint64_t seed = context.seed;
  std::vector<CellJob> jobs;
  jobs.push_back(sweep_job(fmt::format("random, {} points, seed {}", points, seed), all.front().second,
                           fmt::format("solvers: {}", what), version, curves,
                           [all, seed](int index, store::CellRecord& cell) {
                             measure(all, random_curve(seed, index, points, false), cell);
                           }));
  jobs.back().label = label;
  return jobs;
}

std::vector<double> times(const store::ExperimentRecord& record, const std::string& words) {
  std::vector<double> all;
  for (const store::CellRecord& cell : record.cells)
    if (const auto found = cell.timings.find(words); found != cell.timings.end())
      std::ranges::copy(found->second, std::back_inserter(all));
  return all;
}

/// How a way does against Levenberg-Marquardt in the same windows.
struct Against {
  double ratio = 0.0;  ///< median over curves of its time over that of lm
  Tally lower;         ///< curves with a lower energy than lm, by more than a millionth
  Tally higher;
  double energy_ratio = 0.0;  ///< median over curves that both solved
};

Against against(const store::ExperimentRecord& record, const std::string& words, const std::string& lm) {
  Against a;
  const auto own_time = times(record, words), lm_time = times(record, lm);
  std::vector<double> ratios, energy_ratios;
  for (std::size_t i = 0; i < std::min(own_time.size(), lm_time.size()); ++i)
    ratios.push_back(own_time[i] / lm_time[i]);
  a.ratio = median(ratios);
  const auto own = study::values(record, words + ": energy"), other = study::values(record, lm + ": energy");
  for (std::size_t i = 0; i < std::min(own.size(), other.size()); ++i) {
    if (std::isnan(own[i]) || std::isnan(other[i])) continue;
    energy_ratios.push_back(own[i] / other[i]);
    a.lower.add(own[i] < other[i] * (1.0 - 1e-6));
    a.higher.add(own[i] > other[i] * (1.0 + 1e-6));
  }
  a.energy_ratio = median(energy_ratios);
  return a;
}

store::TableRecord table(const store::ExperimentRecord& record, const Registry& registry) {
  TableBuilder builder(
      "solvers", "What minimises a window",
      fmt::format("{} random open C2 curves of {} points, stage 1 alone. Energy: E_p + 0.1 E_e + 0.1 E_c "
                  "per segment with the mean chord as unit, median over solved curves, and median of its ratio to lm. "
                  "Lower, higher: "
                  "curves with a lower or higher energy than by lm in the same windows. Time: processor "
                  "time per inserted point; ratio: median over curves of the time over that of lm.",
                  curves, points));
  builder.words("solver").words("windows").counts("curves").counts("solved").numbers("energy");
  builder.numbers("energy over lm").counts("lower").counts("higher").numbers("time", "ms").numbers("ratio to lm");
  for (const Way& way : ways(registry)) {
    const auto energies = study::values(record, way.words + ": energy");
    if (!way.words.ends_with("stage 1") || energies.empty()) continue;
    const Against a = against(record, way.words, fmt::format("lm, {}, stage 1", way.mode));
    const auto unsolved = std::ranges::count_if(energies, [](double e) { return std::isnan(e); });
    builder.row({way.solver, std::string(way.mode == "paper" ? "as printed" : "robust"),
                 static_cast<double>(energies.size()),
                 static_cast<double>(energies.size()) - static_cast<double>(unsolved), median(energies), a.energy_ratio,
                 a.lower.agree, a.higher.agree, 1e3 * median(times(record, way.words)), a.ratio});
  }
  return builder.table();
}

store::TableRecord whole_table(const store::ExperimentRecord& record) {
  TableBuilder builder("whole", "Window by window and all at once",
                       "The same curves by Levenberg-Marquardt: processor time per inserted point, median of mean E_p "
                       "times mean chord.");
  builder.words("construction").numbers("time", "ms").numbers("mean E");
  for (const std::string words : {"lm, local, stage 1", "lm, local, both stages", "lm, global, both stages"})
    if (const auto own = times(record, words); !own.empty())
      builder.row({words, 1e3 * median(own), median(study::values(record, words + ": mean E"))});
  return builder.table();
}

store::TableRecord counter_table(const store::ExperimentRecord& record) {
  TableBuilder builder("windows", "Windows of the construction",
                       "Counted over all curves, Levenberg-Marquardt: windows solved; those that needed more than the "
                       "usual starts, were widened, kept stage 1, failed verification, met the iteration limit.");
  builder.words("construction");
  constexpr std::array<std::string_view, 6> counters{"windows",         "fallbacks", "widened",
                                                     "stage2_reverted", "unsound",   "iteration_limit"};
  for (const std::string_view counter : counters) builder.counts(std::string(counter));
  for (const std::string words : {"lm, local, stage 1", "lm, paper, stage 1", "lm, local, both stages"}) {
    std::vector<TableBuilder::Cell> row{words};
    for (const std::string_view counter : counters)
      row.emplace_back(study::total(record, fmt::format("{}: {}", words, counter)));
    if (!times(record, words).empty()) builder.row(row);
  }
  return builder.table();
}

store::ClaimRecord cost_claim(const store::ExperimentRecord& record) {
  const auto at_once = times(record, "lm, global, both stages"), windows = times(record, "lm, local, both stages");
  Tally dearer;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(at_once.size(), windows.size()); ++i) {
    dearer.add(at_once[i] > windows[i]);
    ratios.push_back(at_once[i] / windows[i]);
  }
  return claim(
      "global-costs-more", study::verdict_in_general(dearer.agree, dearer.cases),
      fmt::format("the whole curve at once takes longer on {}; median ratio {:.2g}",
                  study::share(dearer.agree, dearer.cases), median(ratios)),
      fmt::format("Processor time of both stages, random curves of {} points inserted one by one, or solved at "
                  "once with a block tridiagonal system. A later edit costs one window, or the whole curve "
                  "again.",
                  points));
}

store::FigureRecord figure() {
  store::PanelRecord time{.kind = "graph", .title = "time per inserted point"};
  time.table = "solvers";
  time.x = "solver";
  time.y = {"time"};
  time.series = "windows";
  time.log_y = true;
  time.y_label = "ms";
  store::PanelRecord solved = time;
  solved.title = "curves solved";
  solved.y = {"solved"};
  solved.log_y = false;
  solved.y_label = "curves";
  store::PanelRecord energy = time;
  energy.title = "energy after stage 1";
  energy.y = {"energy"};
  energy.log_y = false;
  energy.y_label = "median energy";
  for (store::PanelRecord* panel : {&time, &solved, &energy}) panel->lines = false;
  return {.id = "pkappa-solvers",
          .title = "Four solvers",
          .caption =
              "Processor time, curves solved and energy after stage 1 by solver, with windows made robust and as "
              "printed.",
          .columns = 3,
          .panels = {time, solved, energy}};
}

void conclude(const Context& context, store::ExperimentRecord& record) {
  record.tables = {table(record, context.registry), whole_table(record), counter_table(record)};
  record.claims = {cost_claim(record)};
  if (!record.cells.empty()) record.figures = {figure()};
}

}  // namespace

Experiment pkappa_solvers_experiment() {
  return {.id = "pkappa-solvers",
          .title = "Solvers of the windows (Wang 2024, Sections 5 and 6)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
