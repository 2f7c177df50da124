#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "Stage 1 minimises E_p with both other terms, stage 2 goes on from there: as printed with E_p alone (mode=paper, "
    "at most 10 iterations), by default with a tenth of the weights until it converges (mode=local). Shown for one "
    "drawing with combs and with curvature over t against the parabolas, then for random curves and for typical "
    "inputs, where a solution of the whole curve at once (mode=global) shows what the windows give away.";

struct Stage {
  std::string_view words, options;
};
constexpr std::array<Stage, 6> stages{{{"printed, stage 1", "mode=paper,stage2_iterations=0"},
                                       {"printed, stage 2", "mode=paper"},
                                       {"local, stage 1", "stage2_iterations=0"},
                                       {"local, stage 2", ""},
                                       {"global, stage 1", "mode=global,stage2_iterations=0"},
                                       {"global, stage 2", "mode=global"}}};
constexpr std::array<std::size_t, 3> drawn_stages{0, 1, 5};
constexpr std::array<std::string_view, 9> inputs{"toy",    "s-curve",         "zigzag-sharp", "circle-even", "spiral",
                                                 "stages", "log-spiral-even", "leaf",         "very-uneven"};
constexpr std::string_view shown = "stages";
constexpr int version = 1, points = 8, curves = 20;

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const std::vector<const Metric*> metrics{&find_metric("parabola_energy"), &find_metric("monotone_intervals")};
  // In the unit of the mean chord, so that all three modes minimise the same.
  const Drawing stand_in = scaled_to(drawing(shown), 1.0);
  for (const std::size_t k : drawn_stages)
    jobs.push_back(
        profiled_job(stand_in, pkappa(context.registry, stages[k].options), std::string(stages[k].words), metrics));
  const std::uint64_t seed = context.seed;
  for (const Stage& stage : stages) {
    const SchemePtr scheme = pkappa(context.registry, stage.options);
    const auto energy = [scheme](const Input& input, store::CellRecord& cell) {
      const Fit fit = scheme->fit(input);
      study::put(cell, "mean E", study::solved(fit) ? mean(parabola_energies(*fit.curve)) : std::nan(""),
                 Method::sampled);
    };
    jobs.push_back(sweep_job(fmt::format("random, {} points, seed {}", points, seed), scheme,
                             fmt::format("random: {}", stage.words), version, curves,
                             [energy, seed](int index, store::CellRecord& cell) {
                               energy(random_curve(seed, index, points, false), cell);
                             }));
    jobs.push_back(sweep_job("typical inputs", scheme, fmt::format("typical: {}", stage.words), version,
                             static_cast<int>(inputs.size()), [energy](int index, store::CellRecord& cell) {
                               const auto id = inputs[static_cast<std::size_t>(index)];
                               energy(scaled_to(drawing(id).curves.front(), 1.0), cell);
                             }));
  }
  return jobs;
}

std::vector<double> energies(const store::ExperimentRecord& record, std::string_view of, const Stage& stage) {
  std::vector<double> all;
  for (const int c : cells_labelled(record, fmt::format("{}: {}", of, stage.words)))
    for (const store::MeasurementRecord& m : record.cells[static_cast<std::size_t>(c)].measurements)
      if (m.column == "mean E") all.push_back(m.value);
  return all;
}

store::TableRecord typical_table(const store::ExperimentRecord& record) {
  TableBuilder builder("typical", "Mean E_p of typical inputs",
                       "First curve of each drawing, scaled to mean chord 1; C2. Empty where it was not solved.");
  builder.words("drawing");
  for (const Stage& stage : stages) builder.numbers(std::string(stage.words));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::vector<TableBuilder::Cell> row{std::string(inputs[i])};
    for (const Stage& stage : stages) {
      const auto all = energies(record, "typical", stage);
      row.emplace_back(i < all.size() ? all[i] : std::nan(""));
    }
    builder.row(row);
  }
  return builder.table();
}

struct Comparison {
  Tally lower;
  std::vector<double> ratios;  ///< stage 1 over stage 2
};

Comparison compared(const store::ExperimentRecord& record, std::size_t first) {
  Comparison c;
  const auto before = energies(record, "random", stages[first]), after = energies(record, "random", stages[first + 1]);
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    if (std::isnan(before[i]) || std::isnan(after[i])) continue;
    c.lower.add(after[i] < before[i]);
    c.ratios.push_back(before[i] / after[i]);
  }
  return c;
}

store::TableRecord random_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "random", "Stage 1 against stage 2 on random curves",
      fmt::format("{} random open curves of {} points, mean chord 1; curves that both stages solved.", curves, points));
  builder.words("mode").counts("curves").counts("stage 2 lower").numbers("median E, stage 1");
  builder.numbers("median E, stage 2").numbers("median ratio");
  for (const std::size_t first : {0UL, 2UL, 4UL}) {
    const Comparison c = compared(record, first);
    if (c.ratios.empty()) continue;
    const std::string_view words = stages[first].words;
    builder.row({std::string(words.substr(0, words.find(','))), c.lower.cases, c.lower.agree,
                 median(energies(record, "random", stages[first])),
                 median(energies(record, "random", stages[first + 1])), median(c.ratios)});
  }
  return builder.table();
}

store::ClaimRecord stage_claim(const store::ExperimentRecord& record) {
  const Comparison printed = compared(record, 0), local = compared(record, 2);
  return claim(
      "stage-2-lowers-energy", study::verdict_in_general(printed.lower.agree, printed.lower.cases),
      fmt::format("mean E lower after stage 2 on {}, median ratio {:.3g}",
                  study::share(printed.lower.agree, printed.lower.cases), median(printed.ratios)),
      fmt::format("Windows as printed, random curves with mean chord 1, stage 2 of at most 10 iterations. With a "
                  "tenth of the weights kept until it converges (default): {}, median ratio {:.3g}.",
                  study::share(local.lower.agree, local.lower.cases), median(local.ratios)));
}

void conclude(const Context& context, store::ExperimentRecord& record) {
  record.tables = {typical_table(record), random_table(record)};
  record.claims = {stage_claim(record)};
  store::FigureRecord figure{
      .id = "pkappa-stages",
      .title = "Two stages",
      .caption =
          "Stage 1 and stage 2 as printed, and the whole curve at once. Above with combs; below curvature "
          "and parabolas, segment after segment, and their difference. Stand-in for Fig. 9.",
      .columns = 3,
      .panels = {}};
  std::vector<store::PanelRecord> graphs, differences;
  for (const std::size_t k : drawn_stages)
    if (const auto cell = study::drawn_cell(record, shown, stages[k].words)) {
      const std::string table = fmt::format("parabolas-{}", k);
      record.tables.push_back(parabola_table(study::Findings(context, paper, record), table, {*cell}, 16).record());
      figure.panels.push_back(curve_panel({*cell}, std::string(stages[k].words), true));
      differences.push_back(difference_panel(std::string(stages[k].words), table));
      graphs.push_back(parabola_panel(std::string(stages[k].words), table, "segment + t"));
    }
  std::ranges::move(graphs, std::back_inserter(figure.panels));
  std::ranges::move(differences, std::back_inserter(figure.panels));
  if (!figure.panels.empty()) record.figures = {std::move(figure)};
}

}  // namespace

Experiment pkappa_stages_experiment() {
  return {.id = "pkappa-stages",
          .title = "Two stages (Wang 2024, Fig. 9)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
