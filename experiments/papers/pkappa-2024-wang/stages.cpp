// Wang 2024, Fig. 9: what does stage 2 of the minimisation add to stage 1?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/papers/pkappa-2024-wang/parabolas.hpp"
#include "experiments/papers/pkappa-2024-wang/two_ways.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table;

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
                                       {"local, stage 1", "unit=chord,stage2_iterations=0"},
                                       {"local, stage 2", "unit=chord"},
                                       {"global, stage 1", "mode=global,unit=chord,stage2_iterations=0"},
                                       {"global, stage 2", "mode=global,unit=chord"}}};
constexpr std::array<std::size_t, 3> drawn_stages{0, 1, 5};
constexpr std::string_view shown = "stages", typical = "typical inputs";

// ---- what is measured

constexpr std::array<std::string_view, 9> inputs{"toy",    "s-curve",         "zigzag-sharp", "circle-even", "spiral",
                                                 "stages", "log-spiral-even", "leaf",         "very-uneven"};
constexpr int points = 8, curves = 20;
const study::Key input_name{"drawing"};
const Quantity mean_energy{"mean E", "1/length", Method::sampled};

void measure_random(const Uses& uses, Notes& notes) {
  for (int i = 0; i < curves; ++i)
    notes.row({curve_number(i)},
              {mean_energy(mean_energy_of(uses.schemes.front()->fit(random_curve(uses.seed, i, points, false))))});
}

void measure_typical(const Uses& uses, Notes& notes) {
  for (const Drawing& drawing : uses.drawings)
    notes.row({input_name(drawing.id)},
              {mean_energy(mean_energy_of(uses.schemes.front()->fit(drawing.curves.front())))});
}

std::string random_name(const Context& context) {
  return fmt::format("random, {} points, seed {}", points, context.seed);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Metric& energy = find_metric("parabola_energy");
  // In the unit of the mean chord, so that all three modes minimise the same.
  jobs.reserve(drawn_stages.size() + stages.size());
  for (const std::size_t k : drawn_stages)
    jobs.push_back(profiled_job(scaled_to(drawing(shown), 1.0), pkappa(context.registry, stages[k].options),
                                std::string(stages[k].words), {&energy, &find_metric("monotone_intervals")}));
  std::vector<Drawing> typical_drawings;
  typical_drawings.reserve(inputs.size());
  for (const std::string_view id : inputs) typical_drawings.push_back(scaled_to(drawing(id), 1.0));
  for (const auto& [words, options] : stages) {
    const SchemePtr scheme = pkappa(context.registry, options);
    jobs.push_back(study::numbers_job<measure_random>(
        {.work = "stages, random curves", .schemes = {scheme}, .metrics = {&energy}, .seed = context.seed},
        random_name(context), std::string(words)));
    jobs.push_back(study::numbers_job<measure_typical>(
        {.work = "stages, typical inputs", .schemes = {scheme}, .drawings = typical_drawings, .metrics = {&energy}},
        std::string(typical), std::string(words)));
  }
  return jobs;
}

// ---- what follows

Table typical_table(const Rows& rows) {
  Table table("typical", "Mean E_p of typical inputs",
              "First curve of each drawing, scaled to mean chord 1; C2. Empty where it was not solved.");
  table.words("drawing");
  for (const Stage& stage : stages) table.numbers(std::string(stage.words));
  for (const std::string_view id : inputs) {
    std::vector<study::TableValue> row{id};
    for (const Stage& stage : stages)
      row.emplace_back(rows.where({input_name(id), study::key::label(stage.words)}).mean(mean_energy));
    table.row(row);
  }
  return table;
}

/// Stage 1 against stage 2 of the mode that begins with stages[first].
TwoWays compared(const Rows& random, std::size_t first) {
  return TwoWays(
      random.pairs(mean_energy, study::key::label(stages[first].words), study::key::label(stages[first + 1].words)));
}

Table random_table(const Rows& random) {
  Table table(
      "random", "Stage 1 against stage 2 on random curves",
      fmt::format("{} random open curves of {} points, mean chord 1; curves that both stages solved.", curves, points));
  table.words("mode").counts("curves").counts("stage 2 lower").numbers("median E, stage 1");
  table.numbers("median E, stage 2").numbers("median ratio");
  for (const std::size_t first : {0UL, 2UL, 4UL}) {
    const TwoWays both = compared(random, first);
    if (both.ratios.empty()) continue;
    const auto median_of = [&](const Stage& stage) {
      return random.where({study::key::label(stage.words)}).median(mean_energy);
    };
    const std::string_view words = stages[first].words;
    table.row({words.substr(0, words.find(',')), both.second_lower.cases, both.second_lower.agree,
               median_of(stages[first]), median_of(stages[first + 1]), median(both.ratios)});
  }
  return table;
}

void claim_stage_2(Findings& found, const Rows& random) {
  const TwoWays printed = compared(random, 0), local = compared(random, 2);
  found.judge(
      "stage-2-lowers-energy", printed.second_lower,
      {fmt::format("mean E lower after stage 2 on {}, median ratio {:.3g}", printed.second_lower.words(),
                   median(printed.ratios)),
       fmt::format("Windows as printed, random curves with mean chord 1, stage 2 of at most 10 iterations. With a "
                   "tenth of the weights kept until it converges (default): {}, median ratio {:.3g}.",
                   local.second_lower.words(), median(local.ratios)),
       "as printed"});
}

void draw(Findings& found) {
  store::FigureRecord figure{
      .id = "pkappa-stages",
      .title = "Two stages",
      .caption =
          "Stage 1 and stage 2 as printed, and the whole curve at once. Above with combs; below curvature "
          "and parabolas, segment after segment, and their difference. Stand-in for Fig. 9.",
      .columns = 3,
      .panels = {}};
  std::vector<store::PanelRecord> graphs, differences;
  for (const std::size_t k : drawn_stages) {
    const std::string words(stages[k].words);
    const auto cell = found.find(shown, words);
    if (!cell) continue;
    const Table table = parabola_table(found, fmt::format("parabolas-{}", k), {*cell}, 16);
    found.add(table);
    figure.panels.push_back(Panel::curves({*cell}, words).comb());
    graphs.push_back(parabola_panel(words, table.id(), "segment + t"));
    differences.push_back(difference_panel(words, table.id()));
  }
  std::ranges::move(graphs, std::back_inserter(figure.panels));
  std::ranges::move(differences, std::back_inserter(figure.panels));
  found.add(std::move(figure));
}

void conclude(Findings& found) {
  const Rows random = found.rows().where({study::key::dataset(random_name(found.context()))});
  found.add(typical_table(found.rows()));
  found.add(random_table(random));
  claim_stage_2(found, random);
  draw(found);
}

}  // namespace

Experiment pkappa_stages_experiment() {
  return study::experiment({.id = "pkappa-stages",
                            .title = "Two stages (Wang 2024, Fig. 9)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"stage-2-lowers-energy"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
