#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/papers/fpc-2019-chen/inputs.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "A loop is passed at t - alpha and t + beta of its segment. Its size is taken as the arc length between the two, "
    "over the mean chord of the points. Drawn for the two values of Fig. 5; measured for more, on that ring and on "
    "random closed curves of loops.";

constexpr int version = 1;
constexpr std::array sizes{0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45};
constexpr std::array<std::string_view, 2> shown{"loops-size-03", "loops-size-04"};
constexpr int inputs = 100;

/// Loops whose t is this near to 1/2 fit all the sizes.
bool fits_all(double t) { return std::min(t, 1.0 - t) > sizes.back() + 0.01; }

/// The lengths of the loops of the same points for all sizes, in order of the points; empty unless all are solved.
/// A loop that cannot have all sizes is made regular.
std::vector<std::vector<double>> measure(const Scheme& scheme, Input input) {
  const int n = input.size();
  const auto point = [&](int i) { return input.points[static_cast<std::size_t>((i + n) % n)]; };
  input.options.assign(static_cast<std::size_t>(n), {});
  for (int i = 0; i < n; ++i) {
    const double before = (point(i) - point(i - 1)).norm(), after = (point(i + 1) - point(i)).norm();
    if (fits_all(before / (before + after))) input.options[static_cast<std::size_t>(i)].type = PointType::loop;
  }
  std::vector<std::vector<double>> lengths;
  for (const double size : sizes) {
    for (PointOptions& options : input.options)
      if (options.type) options.alpha = options.beta = size;
    const Fit fit = scheme.fit(input);
    if (!study::solved(fit)) return {};
    lengths.emplace_back();
    for (int i = 0; i < n; ++i) {
      const std::vector<Node> nodes = nodes_of(*fit.curve, i);
      if (nodes.size() != 2) continue;
      lengths.back().push_back(length_between(fit.curve->segment(nodes[0].segment), nodes[0].t, nodes[1].t) /
                               mean_chord(input));
    }
  }
  return lengths;
}

void put_lengths(const std::vector<std::vector<double>>& lengths, store::CellRecord& cell) {
  study::put(cell, "inputs", 1.0);
  if (lengths.empty()) {
    study::put(cell, "unsolved", 1.0);
    return;
  }
  for (std::size_t k = 0; k < lengths.size(); ++k)
    for (const double length : lengths[k]) study::put(cell, fmt::format("loop {:.2f}", sizes[k]), length);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(shown.size() + 2);
  const SchemePtr scheme = context.registry.create("fpc");
  for (const std::string_view id : shown) jobs.push_back(fit_job(open_drawings(id).front(), scheme, {}));
  jobs.push_back(study::study_job(open_drawings(shown.front()).front(), scheme, "sizes", version,
                                  [scheme](const Drawing& drawing, store::CellRecord& cell) {
                                    for (const Input& input : drawing.curves)
                                      put_lengths(measure(*scheme, input), cell);
                                  }));
  const std::uint64_t seed = context.seed;
  jobs.push_back(random_job(scheme, fmt::format("loop sizes, seed {}", seed), version, inputs,
                            [scheme, seed](std::uint64_t index, store::CellRecord& cell) {
                              const Input points = random_input(RandomKind::star, 8, seed + index, true);
                              put_lengths(measure(*scheme, points), cell);
                            }));
  return jobs;
}

std::vector<double> loops(const store::ExperimentRecord& record, std::size_t k, std::string_view dataset = {}) {
  return study::values(record, fmt::format("loop {:.2f}", sizes[k]), dataset);
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "loop-sizes", "Size of a loop against alpha = beta",
      "Arc length of a loop over the mean chord of the points, median over the loops: the ring of Fig. "
      "5, and random closed curves of loops.");
  builder.words("points").numbers("alpha = beta").counts("loops").numbers("median length");
  for (const store::CellRecord& cell : record.cells) {
    if (cell.measurements.empty()) continue;
    const std::string words = cell.dataset == shown.front() ? "ring of Fig. 5" : "random";
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const std::vector<double> lengths = loops(record, k, cell.dataset);
      builder.row({words, sizes[k], static_cast<double>(lengths.size()), median(lengths)});
    }
  }
  return builder.table();
}

store::ClaimRecord growth_claim(const store::ExperimentRecord& record) {
  double steps = 0.0, grow = 0.0;
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    const std::vector<double> before = loops(record, k - 1), now = loops(record, k);
    for (std::size_t i = 0; i < now.size(); ++i, steps += 1.0) grow += now[i] > before[i] ? 1.0 : 0.0;
  }
  return claim(
      "loop-size", study::verdict_in_general(grow, steps),
      fmt::format("longer in {} steps of alpha = beta", study::share(grow, steps)),
      fmt::format("alpha = beta from {} to {}, all loops of a curve at once; {} loops. {:.0f} of {:.0f} inputs are "
                  "left out because not all sizes were solved.",
                  sizes.front(), sizes.back(), loops(record, 0).size(), study::total(record, "unsolved"),
                  study::total(record, "inputs")));
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "fpc-loop-size",
                             .title = "Size of loops",
                             .caption =
                                 "The same points with alpha = beta = 0.3 and 0.4, and the arc length of a loop "
                                 "against alpha = beta.",
                             .columns = 3,
                             .panels = {}};
  constexpr std::array<std::string_view, 2> titles{"α = β = 0.3", "α = β = 0.4"};
  for (std::size_t i = 0; i < record.cells.size(); ++i) {
    const auto which = std::ranges::find(shown, record.cells[i].dataset);
    if (which == shown.end() || record.cells[i].curves.empty()) continue;
    figure.panels.push_back(
        curve_panel(static_cast<int>(i), std::string(titles[static_cast<std::size_t>(which - shown.begin())])));
  }
  store::PanelRecord graph{.kind = "graph", .title = "length of a loop"};
  graph.table = "loop-sizes";
  graph.x = "alpha = beta";
  graph.y = {"median length"};
  graph.series = "points";
  graph.log_y = true;
  graph.x_label = "α = β";
  graph.y_label = "median length / mean chord";
  figure.panels.push_back(std::move(graph));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record)};
  record.figures = {figure(record)};
  record.claims = {growth_claim(record)};
}

}  // namespace

Experiment fpc_loop_size_experiment() {
  return {.id = "fpc-loop-size",
          .title = "Size control of loops (Chen 2019, Fig. 5)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
