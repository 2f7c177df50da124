// Chen 2019, Fig. 5: do alpha and beta control the size of a loop?
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "datasets/datasets.hpp"
#include "datasets/random_points.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "schemes/curve/arc_length.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "A loop is passed at t - alpha and t + beta of its segment. Its size is taken as the arc length between the two, "
    "over the mean chord of the points. Drawn for the two values of Fig. 5; measured for more, on that ring and on "
    "random closed curves of loops.";

// ---- what is measured

constexpr std::array sizes{0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45};
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> shown{
    {{"loops-size-03", "α = β = 0.3"}, {"loops-size-04", "α = β = 0.4"}}};
constexpr int inputs = 100;

const Key number{"input"}, point{"point"}, alpha{"alpha = beta"};
const Quantity length{"length", "1", Method::sampled}, solved = study::count_of("solved for all sizes");

/// Loops at every point whose t is so near to 1/2 that all the sizes fit.
Input with_loops(Input input) {
  const int n = input.size();
  const auto at = [&](int i) { return input.points[static_cast<std::size_t>((i + n) % n)]; };
  input.options.assign(static_cast<std::size_t>(n), {});
  for (int i = 0; i < n; ++i) {
    const double before = (at(i) - at(i - 1)).norm(), after = (at(i + 1) - at(i)).norm();
    if (std::min(before, after) > (sizes.back() + 0.01) * (before + after))
      input.options[static_cast<std::size_t>(i)].type = PointType::loop;
  }
  return input;
}

void measure_loops(const Scheme& scheme, int index, Input input, Notes& notes) {
  std::vector<Fit> fits;
  for (const double size : sizes) {
    for (PointOptions& options : input.options)
      if (options.type) options.alpha = options.beta = size;
    fits.push_back(scheme.fit(input));
  }
  const bool all = std::ranges::all_of(fits, study::solved);
  notes.row({number(index)}, {solved(all)});
  for (std::size_t k = 0; all && k < sizes.size(); ++k)
    for (int i = 0; i < input.size(); ++i)
      if (const std::vector<Node> nodes = nodes_of(*fits[k].curve, i); nodes.size() == 2) {
        const double s = arc_length(fits[k].curve->segment(nodes[0].segment), nodes[0].t, nodes[1].t);
        notes.row({number(index), point(i), alpha(sizes[k])}, {length(s / mean_chord(input))});
      }
}

void measure(const Uses& uses, Notes& notes) {
  int index = 0;
  for (const Input& input : uses.drawings.front().curves)
    measure_loops(*uses.schemes.front(), index++, with_loops(input), notes);
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("fpc");
  const auto sizes_of = [&scheme](const Drawing& drawing) {
    return study::numbers_job<measure>({.work = "loop sizes", .schemes = {scheme}, .drawings = {drawing}});
  };
  const Drawing ring = open_drawings(shown[0].first).front(), other = open_drawings(shown[1].first).front();
  Drawing random{.id = fmt::format("random closed curves, seed {}", context.seed)};
  for (std::uint64_t i = 0; i < inputs; ++i)
    random.curves.push_back(random_input(RandomKind::star, 8, context.seed + i, true));
  return {fit_job(ring, scheme, {}), fit_job(other, scheme, {}), sizes_of(ring), sizes_of(random)};
}

// ---- what follows

Table table(const Findings& found) {
  Table table("loop-sizes", "Size of a loop against alpha = beta",
              "Arc length of a loop over the mean chord of the points, median over the loops: the ring of Fig. "
              "5, and random closed curves of loops.");
  table.words("points").numbers("alpha = beta").counts("loops").numbers("median length");
  for (const auto& [dataset, rows] : found.rows().by(study::key::dataset))
    for (const double size : sizes) {
      const study::Rows loops = rows.where({alpha(size)});
      table.row({dataset == study::KeyValue("loops-size-03") ? "ring of Fig. 5" : "random", size, loops.size(),
                 loops.median(length)});
    }
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "fpc-loop-size",
                             .title = "Size of loops",
                             .caption =
                                 "The same points with alpha = beta = 0.3 and 0.4, and the arc length of a loop "
                                 "against alpha = beta.",
                             .columns = 3};
  for (const auto& [id, words] : shown)
    if (const auto cell = found.find(id, "fpc")) figure.panels.push_back(Panel::curves({*cell}, std::string(words)));
  figure.panels.push_back(Panel::graph("loop-sizes", "alpha = beta", {"median length"}, "length of a loop")
                              .series("points")
                              .labels("α = β", "median length / mean chord")
                              .log_y());
  return figure;
}

void conclude(Findings& found) {
  found.add(table(found));
  found.add(figure(found));
  const study::Rows& rows = found.rows();
  study::Tally longer;
  for (std::size_t k = 1; k < sizes.size(); ++k)
    for (const auto& [before, now] : rows.pairs(length, alpha(sizes[k - 1]), alpha(sizes[k]))) longer.add(now > before);
  const study::Tally fits = study::tally_of(rows.values(solved));
  longer += {0.0, fits.misses()};
  found.judge(
      "loop-size", longer,
      {fmt::format("longer in {} steps of alpha = beta", longer.words()),
       fmt::format("alpha = beta from {} to {}, all loops of a curve at once; {} loops. Not all sizes were solved "
                   "for {:.0f} of {:.0f} inputs: one miss each.",
                   sizes.front(), sizes.back(), rows.where({alpha(sizes.front())}).size(), fits.misses(), fits.cases)});
}

}  // namespace

Experiment fpc_loop_size_experiment() {
  return study::experiment({.id = "fpc-loop-size",
                            .title = "Size control of loops (Chen 2019, Fig. 5)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"loop-size"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
