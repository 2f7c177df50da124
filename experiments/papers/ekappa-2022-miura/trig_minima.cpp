// Miura 2022, Sect. 4.1: is the stationary point of the trigonometric curvature a maximum of its magnitude?
#include <fmt/format.h>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"
#include "experiments/study/experiment.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Panel, study::Table;

constexpr std::string_view about =
    "The trigonometric curve passes each point where its curvature is stationary. The paper takes that for a local "
    "maximum of the magnitude. With two legs of equal length it is one only if tan^2 of half the turning angle exceeds "
    "a bound that falls with a and is gone at a = 0.5824; at a = 1/2 every turn below 90 degrees gives a minimum. Here "
    "the points of converged curves are counted at which |curvature| has a minimum instead, as the scheme reports and "
    "as measured by the slope of |curvature| on both sides. The inputs are those of ekappa-pinned.";

// ---- what is measured: family_sweep.hpp

std::vector<CellJob> jobs(const Context& context) {
  std::vector<SchemePtr> schemes = sharpness_ladder(context);
  std::erase_if(schemes, [](const SchemePtr& scheme) { return scheme->info().id != "ekappa-trig"; });
  return sweep_jobs(context, schemes);
}

// ---- what follows

Table minima_table(const Findings& found) {
  Table table("minima", "Points at a minimum of |curvature|, trigonometric basis",
              "Points of converged curves. 'minima': by the scheme's report; 'measured minima', 'measured peaks', "
              "'neither': by the slope of |curvature| on both sides, for points that are not pinned.");
  table.words("family").numbers("a").counts("points").counts("minima").numbers("share minima");
  table.counts("measured minima").counts("measured peaks").counts("neither").counts("pinned").counts("at inflection");
  for (const Swept& s : sweeps(found))
    table.row({s.dataset, s.a, s[points], s[minima], s[minima] / s[points], s[valleys], s[peaks], s[neither], s[pinned],
               s[at_inflection]});
  return table;
}

void claim_maximum(Findings& found) {
  const study::Rows& rows = found.rows();
  const double all = rows.total(points), maxima = rows.total(peaks);
  found.judge("trigonometric-local-maximum", study::Tally{maxima, all},
              {fmt::format("|curvature| has a maximum at {:.0f} and a minimum at {:.0f} of {:.0f} points", maxima,
                           rows.total(valleys), all),
               fmt::format("Minima, measured by slopes: {}. The scheme itself reports {:.0f} minima and {:.0f} pinned "
                           "points.",
                           shares_by_a(sweeps(found), [](const Swept& s) { return s[valleys]; }), rows.total(minima),
                           rows.total(pinned))});
}

void conclude(Findings& found) {
  if (found.cells().empty()) return;
  found.add(minima_table(found));
  found.add({.id = "ekappa-trig-minima",
             .title = "Points at a minimum of |curvature|",
             .caption = "Share of the points at which the magnitude of the trigonometric curve's curvature has a "
                        "minimum, against a. One line a family of inputs.",
             .panels = {Panel::graph("minima", "a", {"share minima"}, "trigonometric basis")
                            .series("family")
                            .labels("a", "share of points at a minimum")}});
  claim_maximum(found);
}

}  // namespace

Experiment ekappa_trig_minima_experiment() {
  return study::experiment({.id = "ekappa-trig-minima",
                            .title = "Where the trigonometric maximum is a minimum",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"trigonometric-local-maximum"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
