// Miura 2022, Sect. 3, property 2: is every point a peak of curvature inside its own segment?
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/papers/ekappa-2022-miura/family_sweep.hpp"
#include "experiments/study/experiment.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Panel, study::Table;

constexpr std::string_view about =
    "The curve is meant to pass every input point where the magnitude of its curvature peaks, inside the point's own "
    "segment. The published equations also have solutions, or only such, in which the joint sits on the input point: "
    "the point is pinned, and |curvature| passes through it without a two-sided peak. A point may also be at an "
    "inflection: its segment has shrunk to nothing. Both are counted over all drawings (without their options for "
    "single points, and without curves of more than 100 points) and over six random families, each open and closed "
    "with 3 to 50 points (trigonometric basis: 3 to 15). The slope of "
    "|curvature| on both sides of every point is measured besides, whatever the scheme says. Curves that did not "
    "converge, and straight lines, count no points.";

// ---- what is measured: family_sweep.hpp

std::vector<CellJob> jobs(const Context& context) { return sweep_jobs(context, sharpness_ladder(context)); }

// ---- what follows

std::vector<Swept> of_basis(const Findings& found, bool trigonometric) {
  std::vector<Swept> swept = sweeps(found);
  std::erase_if(swept, [trigonometric](const Swept& s) { return s.trigonometric() != trigonometric; });
  return swept;
}

Table share_table(const Findings& found, bool trigonometric) {
  Table table(trigonometric ? "pinned-trigonometric" : "pinned-bernstein",
              fmt::format("Pinned points against a, {} basis", trigonometric ? "trigonometric" : "Bernstein"),
              "A row a family and a. Points of converged curves; 'measured': by the slope of |curvature| on "
              "both sides of a point that is not pinned; 'pinned with peak': pinned, and |curvature| peaks at "
              "the joint all the same.");
  table.words("family").numbers("a").counts("curves").counts("converged").numbers("share converged");
  table.counts("points").counts("pinned").counts("at inflection").numbers("share pinned");
  table.counts("measured peaks").counts("measured minima").counts("measured neither").counts("pinned with peak");
  for (const Swept& s : of_basis(found, trigonometric)) {
    const double taken = s[curves] - s[unsupported];
    table.row({s.dataset, s.a, taken, s[converged], s[converged] / taken, s[points], s[pinned], s[at_inflection],
               s[pinned] / s[points], s[peaks], s[valleys], s[neither], s[pinned_peaks]});
  }
  return table;
}

/// Drawings with a pinned point at any a, a column an a.
Table drawing_table(const Findings& found) {
  Table table("pinned-drawings", "Drawings with pinned points",
              "Number of pinned points by basis and a; drawings without any are left out.");
  table.words("drawing").counts("points");
  std::vector<Swept> of_drawings = sweeps(found);
  std::erase_if(of_drawings, [](const Swept& s) { return s.dataset != "drawings"; });
  for (const Swept& s : of_drawings) table.counts(fmt::format("{} a={:.3g}", s.scheme, s.a));
  std::map<std::string, study::Rows> by_name;
  for (const auto& [name, rows] : found.rows().where({study::key::dataset("drawings")}).by(counted))
    by_name.emplace(std::get<std::string>(name), rows);
  for (const auto& [name, rows] : by_name) {
    if (rows.total(pinned) == 0.0) continue;
    std::vector<study::TableValue> row{name, rows.largest(points)};
    for (const double count : rows.values(pinned)) row.emplace_back(count);
    table.row(row);
  }
  return table;
}

store::FigureRecord share_figure(const Findings& found) {
  store::FigureRecord figure{.id = "ekappa-pinned",
                             .title = "Pinned points against a",
                             .caption =
                                 "Share of the interpolated points that are pinned: their joint sits on them "
                                 "and |curvature| has no two-sided peak there. One line a family of inputs.",
                             .columns = 2};
  for (const bool trigonometric : {false, true})
    if (!of_basis(found, trigonometric).empty())
      figure.panels.push_back(Panel::graph(trigonometric ? "pinned-trigonometric" : "pinned-bernstein", "a",
                                           {"share pinned"}, trigonometric ? "trigonometric basis" : "Bernstein basis")
                                  .series("family")
                                  .labels("a", "share of points pinned"));
  return figure;
}

/// On the basis that Section 3 is about.
void claim_peaks(Findings& found) {
  const std::vector<Swept> swept = of_basis(found, false);
  const auto sum = [&swept](const study::Quantity& what) {
    double total = 0.0;
    for (const Swept& s : swept) total += s[what];
    return total;
  };
  if (swept.empty()) return;
  const auto [least, most] = std::ranges::minmax(swept, {}, &Swept::a);
  found.judge(
      "extremum-at-points",
      study::Tally{std::min(sum(peaks), sum(points) - sum(pinned) - sum(at_inflection)), sum(points)},
      {fmt::format("{:.0f} of {:.0f} points have a peak inside their segment", sum(peaks), sum(points)),
       fmt::format("{:.0f} converged curves with {:.3g} <= a <= {:.3g}: {:.0f} points are pinned (the joint sits "
                   "on the point) and {:.0f} are at an inflection; together {}.",
                   sum(converged), least.a, most.a, sum(pinned), sum(at_inflection),
                   shares_by_a(swept, [](const Swept& s) { return s[pinned] + s[at_inflection]; }))});
}

void conclude(Findings& found) {
  found.add(share_table(found, false));
  found.add(share_table(found, true));
  found.add(drawing_table(found));
  found.add(share_figure(found));
  claim_peaks(found);
}

}  // namespace

Experiment ekappa_pinned_experiment() {
  return study::experiment({.id = "ekappa-pinned",
                            .title = "Points without a peak of curvature",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"extremum-at-points"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
