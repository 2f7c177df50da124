#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"
#include "experiments/study/summaries.hpp"

namespace kappabench {

namespace {

constexpr std::string_view about =
    "The trigonometric curve passes each point where its curvature is stationary. The paper takes that for a local "
    "maximum of the magnitude. With two legs of equal length it is one only if tan^2 of half the turning angle exceeds "
    "a bound that falls with a and is gone at a = 0.5824; at a = 1/2 every turn below 90 degrees gives a minimum. Here "
    "the points of converged curves are counted at which |curvature| has a minimum instead, as the scheme reports and "
    "as measured by the slope of |curvature| on both sides. The inputs are those of ekappa-pinned.";

double value(const store::CellRecord& cell, std::string_view column) { return measured(cell, column).value_or(0.0); }

std::vector<CellJob> jobs(const Context& context) {
  std::vector<SchemePtr> schemes = sharpness_ladder(context);
  std::erase_if(schemes, [](const SchemePtr& scheme) { return scheme->info().id != "ekappa-trig"; });
  return sweep_jobs(context, schemes);
}

store::TableRecord minima_table(const store::ExperimentRecord& record) {
  TableBuilder builder("minima", "Points at a minimum of |curvature|, trigonometric basis",
                       "Points of converged curves. 'minima': by the scheme's report; 'measured minima', 'measured "
                       "peaks', 'neither': by the slope of |curvature| on both sides, for points that are not pinned.");
  builder.words("family").numbers("a").counts("points").counts("minima").numbers("share minima");
  builder.counts("measured minima").counts("measured peaks").counts("neither").counts("pinned").counts("at inflection");
  for (const store::CellRecord& cell : record.cells)
    builder.row({cell.dataset, value(cell, "a"), value(cell, "points"), value(cell, "minima"),
                 value(cell, "minima") / value(cell, "points"), value(cell, "valleys"), value(cell, "peaks"),
                 value(cell, "neither"), value(cell, "pinned"), value(cell, "at inflection")});
  return builder.table();
}

/// Miura 2022, Section 4.1.
std::optional<store::ClaimRecord> claim(const store::ExperimentRecord& record) {
  double points = 0, peaks = 0, valleys = 0, pinned = 0, flagged = 0;
  std::map<double, std::pair<double, double>> by_a;  // points, valleys
  for (const store::CellRecord& cell : record.cells) {
    points += value(cell, "points");
    peaks += value(cell, "peaks");
    valleys += value(cell, "valleys");
    pinned += value(cell, "pinned");
    flagged += value(cell, "minima");
    auto& [of_a, minima] = by_a[value(cell, "a")];
    of_a += value(cell, "points");
    minima += value(cell, "valleys");
  }
  if (points == 0.0) return std::nullopt;
  std::string shares;
  for (const auto& [a, counts] : by_a)
    shares +=
        fmt::format("{}{:.3g} % at a = {:.3g}", shares.empty() ? "" : ", ", 100.0 * counts.second / counts.first, a);
  return store::ClaimRecord{
      .paper = "ekappa-2022-miura",
      .claim = "trigonometric-local-maximum",
      .verdict = peaks == points ? "reproduced" : "contradicted",
      .ours = fmt::format("|curvature| has a maximum at {:.0f} and a minimum at {:.0f} of {:.0f} points", peaks,
                          valleys, points),
      .evidence =
          fmt::format("Minima, measured by slopes: {}. The scheme itself reports {:.0f} minima and {:.0f} pinned "
                      "points.",
                      shares, flagged, pinned)};
}

void conclude(const Context&, store::ExperimentRecord& record) {
  if (record.cells.empty()) return;
  record.tables = {minima_table(record)};
  record.figures = {{.id = "ekappa-trig-minima",
                     .title = "Points at a minimum of |curvature|",
                     .caption = "Share of the points at which the magnitude of the trigonometric curve's curvature has "
                                "a minimum, against a. One line a family of inputs.",
                     .panels = {{.kind = "graph",
                                 .title = "trigonometric basis",
                                 .table = "minima",
                                 .x = "a",
                                 .y = {"share minima"},
                                 .series = "family",
                                 .x_label = "a",
                                 .y_label = "share of points at a minimum"}}}};
  if (const auto verdict = claim(record)) record.claims = {*verdict};
}

}  // namespace

Experiment ekappa_trig_minima_experiment() {
  return {.id = "ekappa-trig-minima",
          .title = "Where the trigonometric maximum is a minimum",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
