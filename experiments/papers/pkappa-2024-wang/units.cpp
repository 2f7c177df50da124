// Our own study: in which unit of length should the energies of Wang 2024, Eqs. (3) to (5), be added up?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "datasets/random_points.hpp"
#include "datasets/uneven_points.hpp"
#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/timing.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "E_p is a curvature squared times a length, E_c a length squared and E_e a length to the fourth power, so the "
    "weights of Eq. (9) mean something only with a unit of length, which the paper does not print. With the mean chord "
    "for all spans, E_e of a span a thousand times as long counts 10^12 times, and a wide loop of small curvature can "
    "have less energy than a tight corner. Here the same random drawings are fitted with each span's energies in its "
    "own chords (unit=span, the default) and with the mean chord as the unit (unit=chord), window by window and as one "
    "problem. Wild: a span longer than 1.5 times the shortest that another scheme draws there.";

struct Way {
  std::string_view words, options;
};
constexpr std::array<Way, 4> ways{{{"span, local", "unit=span"},
                                   {"chord, local", "unit=chord"},
                                   {"span, global", "mode=global,unit=span"},
                                   {"chord, global", "mode=global,unit=chord"}}};
constexpr auto &own = ways[0], &mean = ways[1];

/// What a drawing's span is held against.
constexpr std::array<std::string_view, 4> others{"kappa", "yuksel", "cubic-spline", "hobby"};
constexpr double wild_from = 1.5;

// ---- the drawings

constexpr std::string_view even = "even", corner_drawing = "corner";
constexpr int curves = 4, even_points = 12;

Input input_of(std::string_view kind, std::uint64_t seed, int index) {
  const std::uint64_t own_seed = 1000 * seed + static_cast<std::uint64_t>(index);
  for (const UnevenKind uneven : uneven_kinds())
    if (name(uneven) == kind) return uneven_input(uneven, own_seed);
  return random_input(RandomKind::walk, even_points, own_seed, false);
}

std::vector<std::string> kinds() {
  std::vector<std::string> all{std::string(even)};
  for (const UnevenKind kind : uneven_kinds()) all.emplace_back(name(kind));
  return all;
}

/// A corner of three short chords between two long sides.
Drawing tight_corner() {
  return drawing_of(std::string(corner_drawing),
                    {.points = {{100, 0}, {200, 0}, {201.8, 1}, {202, 2}, {202, 100}}, .closed = false});
}

// ---- what is measured

constexpr std::string_view kind_word = "kind of drawing";
const study::Key kind_key{std::string(kind_word)}, curve_key{"curve"}, way_key{"way"};
const Quantity converged = study::count_of("converged"), longest{"longest span", "1", Method::sampled},
               energy{"energy", "1", Method::sampled}, seconds{"seconds", "s", Method::sampled};

double longest_span(const Fit& fit, const std::vector<double>& shortest) {
  const std::vector<double> lengths = span_lengths(fit);
  double ratio = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    if (std::isfinite(lengths[i]) && std::isfinite(shortest[i])) ratio = std::max(ratio, lengths[i] / shortest[i]);
  return ratio;
}

/// The schemes after the ways are those that a span is held against.
void measure_kind(const Uses& uses, Notes& notes) {
  const std::string& kind = uses.words.at(std::string(kind_word));
  for (int i = 0; i < curves; ++i) {
    const Input input = input_of(kind, uses.seed, i);
    std::vector<double> shortest(input.points.size(), std::numeric_limits<double>::infinity());
    for (std::size_t s = ways.size(); s < uses.schemes.size(); ++s) {
      const Fit fit = uses.schemes[s]->fit(input);
      if (!study::solved(fit)) continue;
      const std::vector<double> lengths = span_lengths(fit);
      for (std::size_t k = 0; k < shortest.size(); ++k) shortest[k] = std::min(shortest[k], lengths[k]);
    }
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const double start = processor_seconds();
      const Fit fit = uses.schemes[w]->fit(input);
      const double time = processor_seconds() - start;
      const bool good = study::solved(fit);
      notes.row({kind_key(kind), curve_key(i), way_key(ways[w].words)},
                {converged(good ? 1 : 0), longest(good ? longest_span(fit, shortest) : undefined),
                 energy(good ? mean_own_energy(*fit.curve, input) : undefined), seconds(time)});
    }
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<SchemePtr> schemes;
  schemes.reserve(ways.size() + others.size());
  for (const Way& way : ways) schemes.push_back(pkappa(context.registry, way.options));
  for (const std::string_view id : others) schemes.push_back(context.registry.parse(std::string(id)));
  std::vector<CellJob> jobs;
  for (const Way* way : {&own, &mean})
    jobs.push_back(fit_job(tight_corner(), pkappa(context.registry, way->options), {&find_metric("parabola_energy")},
                           std::string(way->words)));
  for (const std::string& kind : kinds())
    jobs.push_back(study::numbers_job<measure_kind>({.work = "units",
                                                     .schemes = schemes,
                                                     .metrics = {&find_metric("parabola_energy")},
                                                     .seed = context.seed,
                                                     .words = {{std::string(kind_word), kind}}},
                                                    fmt::format("random, {}, seed {}", kind, context.seed), kind));
  return jobs;
}

// ---- what follows

Table table_of(const Findings& found) {
  Table table(
      "units", "The unit of length in the energies",
      fmt::format("{} random drawings of each kind. Wild: converged curves with a span longer than {} times the "
                  "shortest that {} draw there; longest span: the largest such ratio. Energy: E_p + 0.01 E_e + "
                  "0.01 E_c of a segment with lengths over the mean of the two chords at its point, mean over "
                  "the curve, median over the converged curves: the same for every unit, and without one. "
                  "Time: of the processor, a curve, median.",
                  curves, wild_from, fmt::join(others, ", ")));
  table.words("drawings").words("unit, mode").counts("converged").counts("wild").numbers("longest span");
  table.numbers("energy").numbers("time", "ms");
  for (const std::string& kind : kinds())
    for (const Way& way : ways) {
      const Rows rows = found.rows().where({kind_key(kind), way_key(way.words)});
      if (rows.empty()) continue;
      const std::vector<double> spans = rows.values(longest);
      table.row({kind, way.words, rows.total(converged),
                 std::ranges::count_if(spans, [](double s) { return s > wild_from; }), rows.largest(longest),
                 rows.median(energy), 1e3 * rows.median(seconds)});
    }
  return table;
}

void conclude(Findings& found) {
  const Table table = table_of(found);
  found.add(table);
  std::vector<store::PanelRecord> panels;
  for (const Way* way : {&own, &mean})
    if (const auto cell = found.find(corner_drawing, way->words))
      panels.push_back(Panel::curves({*cell}, fmt::format("a tight corner: {}", way->words)));
  const auto by_kind = [&](std::string column, std::string title, std::string label) {
    return Panel::graph(table.id(), "drawings", {std::move(column)}, std::move(title))
        .series("unit, mode")
        .labels("", std::move(label))
        .dots();
  };
  panels.push_back(by_kind("longest span", "longest span", "times the shortest of others").log_y());
  panels.push_back(by_kind("energy", "energy in own chords", "median energy").log_y());
  found.add({.id = "pkappa-units",
             .title = "One unit for all spans, or each its own",
             .caption =
                 "A corner of three short chords between long sides, with each span's energies in its own chords "
                 "and in the mean chord. Below: the longest span and the energy by kind of drawing.",
             .columns = 2,
             .panels = std::move(panels)});
}

}  // namespace

Experiment pkappa_units_experiment() {
  return study::experiment({.id = "pkappa-units",
                            .title = "The unit of length in the energies (a study of ours)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
