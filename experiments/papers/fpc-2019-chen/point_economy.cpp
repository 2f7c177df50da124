#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "datasets/datasets.hpp"
#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

using namespace fpc;

namespace {

constexpr std::string_view about =
    "A ring of twelve loops, once from twelve points of type loop, once from thirty-six points through which a "
    "kappa-curve makes its loops by itself. Both the loops and where they close are counted on the exact curves.";

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> shown{
    {{"ring-of-loops", "fpc"}, {"ring-of-loops-36", "kappa"}}};

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  jobs.reserve(shown.size() + 1);
  for (const auto& [drawing, scheme] : shown)
    jobs.push_back(
        fit_job(open_drawings(drawing).front(), context.registry.create(scheme), {&find_metric("features")}));
  return jobs;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  const Loops typed = loops_of(record, shown[0].first, shown[0].second);
  const Loops plain = loops_of(record, shown[1].first, shown[1].second);
  TableBuilder builder("points", "Points for twelve loops",
                       "A loop of a typed point has two numbers besides, α and β.");
  builder.words("curve").counts("points").counts("loops").counts("loops that close at a point");
  store::FigureRecord figure{.id = "fpc-point-economy",
                             .title = "Twelve loops from twelve and from thirty-six points",
                             .caption =
                                 "Left: the FPC-curve of twelve points of type loop. Right: the κ-curve of "
                                 "thirty-six points.",
                             .columns = 2,
                             .panels = {}};
  for (const auto& [ring, words] : {std::pair(typed, "FPC"), std::pair(plain, "κ-curve")}) {
    if (ring.cell < 0) continue;
    builder.row({std::string(words), ring.points, ring.loops, ring.at_points});
    figure.panels.push_back(curve_panel(ring.cell, fmt::format("{}, {:.0f} points", words, ring.points)));
  }
  record.tables = {builder.table()};
  if (!figure.panels.empty()) record.figures = {std::move(figure)};
  const bool both = typed.cell >= 0 && plain.cell >= 0 && plain.loops > 0.0;
  const bool holds = typed.loops == plain.loops && typed.at_points == typed.loops && 3.0 * typed.points <= plain.points;
  record.claims = {
      claim("twelve-points",
            !both   ? "not reproduced"
            : holds ? "reproduced"
                    : "contradicted",
            fmt::format("{:.0f} points make {:.0f} loops, {:.0f} of them at points; {:.0f} points make "
                        "{:.0f}, {:.0f} of them at points",
                        typed.points, typed.loops, typed.at_points, plain.points, plain.loops, plain.at_points),
            "Drawings ring-of-loops and ring-of-loops-36, our own stand-ins: that thirty-six points are "
            "needed for a κ-curve is not tested.")};
}

}  // namespace

Experiment fpc_point_economy_experiment() {
  return {.id = "fpc-point-economy",
          .title = "Twelve typed points and thirty-six plain ones (Chen 2019, Fig. 9)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
