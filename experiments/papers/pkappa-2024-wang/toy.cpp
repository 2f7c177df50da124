// Wang 2024, Fig. 5: one quintic segment through three points, its curvature and its parabola.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/papers/pkappa-2024-wang/common.hpp"
#include "experiments/papers/pkappa-2024-wang/energies.hpp"
#include "experiments/papers/pkappa-2024-wang/inputs.hpp"
#include "experiments/papers/pkappa-2024-wang/parabolas.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/measured.hpp"
#include "metrics/extremum_offset.hpp"
#include "metrics/monotone_intervals.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench {
namespace {

using namespace wang;
using study::Findings, study::Notes, study::Panel, study::Quantity, study::Table;

constexpr std::string_view about =
    "The smallest pκ-curve: three points, one quintic segment. Its curvature is drawn over t together with the "
    "parabola that it approximates, whose vertex is at the parameter of the middle point. Single segments through "
    "random triples of points show how far the curvature falls on one side of the point and rises on the other, as the "
    "parabola does.";

// ---- what is measured

constexpr int triples = 200, samples = 200;
constexpr std::string_view drawn_name = "toy", drawn_label = "pκ, C2";
const Quantity same_trend{"same trend", "1", Method::sampled}, energy{"E_p times mean chord", "1", Method::sampled};

/// Three points: unit legs in any ratio up to 1 : 4, any turn up to 150 degrees.
Input triple(std::uint64_t seed, int index) {
  Input input = random_curve(seed, 4 * index, 3, false);
  const double stretch = std::pow(4.0, (index % 9) / 4.0 - 1.0);
  input.points[2] = input.points[1] + stretch * (input.points[2] - input.points[1]);
  return input;
}

/// On how much of [0, 1] the curvature runs the way its parabola does.
double share_of_trend(const Segment& segment, double t) {
  const Parabola q = best_parabola(segment, t).parabola;
  const auto kappa = [&](int j) { return curvature(segment.jet(static_cast<double>(j) / samples, 2)); };
  study::Tally tally;
  for (int j = 0; j < samples; ++j) {
    const double slope = q.a1 + 2.0 * q.a2 * (j + 0.5) / samples;
    tally.add((kappa(j + 1) - kappa(j)) * slope > 0.0);
  }
  return tally.share();
}

void measure_triples(const Uses& uses, Notes& notes) {
  for (int i = 0; i < triples; ++i) {
    const Fit fit = uses.schemes.front()->fit(triple(uses.seed, i));
    if (!study::solved(fit)) continue;
    const Node node = inner_nodes(*fit.curve).front();
    notes.put(same_trend(share_of_trend(fit.curve->segment(node.segment), node.t)));
    notes.put(energy(parabola_energies(*fit.curve).front() * mean_chord(fit.input)));
  }
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = pkappa(context.registry, "");
  const std::vector<const Metric*> shown{&find_metric("parabola_energy"), &find_metric("monotone_intervals"),
                                         &find_metric("extremum_offset")};
  return {profiled_job(drawing(drawn_name), scheme, std::string(drawn_label), shown),
          study::numbers_job<measure_triples>({.work = "random triples",
                                               .schemes = {scheme},
                                               .metrics = {&find_metric("parabola_energy")},
                                               .seed = context.seed},
                                              fmt::format("random triples, seed {}", context.seed))};
}

// ---- what follows

Table numbers(const store::CurveRecord& curve) {
  Table table(
      "toy", "The segment in numbers",
      "E_p is the integral of (κ - Q)² over arc length; times the mean chord it does not depend on the unit. The "
      "offset is the arc length from the point to the nearest extremum of curvature over the local chord.");
  table.words("quantity").numbers("value");
  for (const auto& [name, column] : {std::pair("E_p (1/length)", &column::parabola_energy_native.mean),
                                     std::pair("E_p times mean chord", &column::parabola_energy_native.scaled_mean),
                                     std::pair("intervals of monotone curvature", &column::intervals_per_segment_mean),
                                     std::pair("offset of the point", &column::extremum_offset_mean)})
    table.row({name, measured(curve, *column).value_or(undefined)});
  for (const double t : curve.node_t)
    if (t > 0.0 && t < 1.0) table.row({"t of the point", t});
  return table;
}

void claim_trend(Findings& found) {
  const std::vector<double> shares = found.rows().values(same_trend);
  const auto cases = static_cast<double>(shares.size()), full = static_cast<double>(std::ranges::count(shares, 1.0));
  const double average = shares.empty() ? 0.0 : mean(shares);
  found.judge(
      "parabola-trend", study::Tally{average * cases, cases},
      {fmt::format("κ' has the sign of the parabola's slope on {:.1f} % of [0, 1] on average", 100.0 * average),
       fmt::format("{:.0f} single segments through random triples (legs of 4 : 1 to 1 : 4), {:.0f} of them with "
                   "the sign of the parabola's slope everywhere; median E_p times mean chord {:.2g}.",
                   cases, full, found.rows().median(energy))});
}

void conclude(Findings& found) {
  claim_trend(found);
  const auto cell = found.find(drawn_name, drawn_label);
  if (!cell) return;
  found.add(numbers(*found.curve(*cell)));
  found.add(parabola_table(found, "toy-parabola", {*cell}, 32));
  found.add({.id = "pkappa-toy",
             .title = "One segment through three points",
             .caption =
                 "Left: the curve with its comb. Right: its curvature over t and the parabola with its vertex at "
                 "the middle point's t.",
             .columns = 2,
             .panels = {Panel::curves({*cell}, "curve and comb").comb(),
                        parabola_panel("curvature and parabola", "toy-parabola", "t")}});
}

}  // namespace

Experiment pkappa_toy_experiment() {
  return study::experiment({.id = "pkappa-toy",
                            .title = "One segment (Wang 2024, Fig. 5)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"parabola-trend"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
