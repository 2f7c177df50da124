// Chen 2019, Fig. 9: a ring of twelve loops, from twelve typed points and from thirty-six plain ones.
#include <fmt/format.h>

#include "experiments/papers/fpc-2019-chen/common.hpp"
#include "experiments/study/experiment.hpp"

namespace kappabench {
namespace {

using namespace chen;
using study::Findings, study::Panel, study::Table;

constexpr std::string_view about =
    "A ring of twelve loops, once from twelve points of type loop, once from thirty-six points through which a "
    "kappa-curve makes its loops by itself. Both the loops and where they close are counted on the exact curves.";

// ---- what is measured

constexpr LoopCase typed{"ring-of-loops", "fpc", "FPC"}, plain{"ring-of-loops-36", "kappa", "κ-curve"};

std::vector<CellJob> jobs(const Context& context) { return {loops_job(context, typed), loops_job(context, plain)}; }

// ---- what follows

void show(Findings& found) {
  Table table("points", "Points for twelve loops", "A loop of a typed point has two numbers besides, α and β.");
  table.words("curve").counts("points").counts("loops").counts("loops that close at a point");
  store::FigureRecord figure{.id = "fpc-point-economy",
                             .title = "Twelve loops from twelve and from thirty-six points",
                             .caption =
                                 "Left: the FPC-curve of twelve points of type loop. Right: the κ-curve of "
                                 "thirty-six points.",
                             .columns = 2};
  for (const LoopCase& which : {typed, plain}) {
    const Loops ring = loops_of(found, which);
    if (!ring.drawn()) continue;
    table.row({which.title, ring.points, ring.loops, ring.at_points});
    figure.panels.push_back(Panel::curves({ring.cell}, fmt::format("{}, {:.0f} points", which.title, ring.points)));
  }
  found.add(table);
  found.add(std::move(figure));
}

void conclude(Findings& found) {
  show(found);
  const Loops few = loops_of(found, typed), many = loops_of(found, plain);
  found.by_construction(
      "twelve-points",
      {fmt::format("{:.0f} points make {:.0f} loops, {:.0f} of them at points; {:.0f} points make "
                   "{:.0f}, {:.0f} of them at points",
                   few.points, few.loops, few.at_points, many.points, many.loops, many.at_points),
       "Drawings ring-of-loops and ring-of-loops-36 are our own, made to have twelve loops from twelve "
       "and from thirty-six points: that a κ-curve needs so many is not tested."});
}

}  // namespace

Experiment fpc_point_economy_experiment() {
  return study::experiment({.id = "fpc-point-economy",
                            .title = "Twelve typed points and thirty-six plain ones (Chen 2019, Fig. 9)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"twelve-points"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
