#include "experiments/pkappa_toy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/pkappa_common.hpp"
#include "experiments/summaries.hpp"
#include "metrics/parabola_energy.hpp"

namespace kappabench {

using namespace wang;

namespace {

constexpr std::string_view about =
    "The smallest pκ-curve: three points, one quintic segment. Its curvature is drawn over t together with the "
    "parabola that it approximates, whose vertex is at the parameter of the middle point. Single segments through "
    "random triples of points show how far the curvature falls on one side of the point and rises on the other, as the "
    "parabola does.";

constexpr int version = 1, triples = 200, samples = 200;
constexpr std::string_view random_name = "random triples", shown = "toy";

/// Three points: unit legs in any ratio up to 1 : 4, any turn up to 150 degrees.
Input triple(std::uint64_t seed, int index) {
  Input input = random_curve(seed, 4 * index, 3, false);
  const double stretch = std::pow(4.0, static_cast<double>(index % 9) / 4.0 - 1.0);
  input.points[2] = input.points[1] + stretch * (input.points[2] - input.points[1]);
  return input;
}

/// On how much of [0, 1] the curvature runs the way its parabola does.
Tally trend(const Curve& curve) {
  const auto inside = std::ranges::find_if(curve.nodes(), [](const Node& n) { return n.t > 0.0 && n.t < 1.0; });
  const Segment& segment = curve.segment(inside->segment);
  const Parabola q = best_parabola(segment, inside->t).parabola;
  Tally tally;
  const auto kappa = [&](int j) { return curvature(segment.jet(static_cast<double>(j) / samples, 2)); };
  for (int j = 0; j < samples; ++j) {
    const double middle = (j + 0.5) / samples, slope = q.a1 + 2.0 * q.a2 * middle;
    tally.add((kappa(j + 1) - kappa(j)) * slope > 0.0);
  }
  return tally;
}

void measure(const Scheme& scheme, const Input& input, store::CellRecord& cell) {
  const Fit fit = scheme.fit(input);
  if (!study::solved(fit)) return;
  const Tally tally = trend(*fit.curve);
  study::put(cell, "same trend", tally.agree / tally.cases, Method::sampled);
  study::put(cell, "E_p", parabola_energies(*fit.curve).front() * mean_chord(input), Method::sampled);
}

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = pkappa(context.registry, "");
  const std::vector<const Metric*> metrics{&find_metric("parabola_energy"), &find_metric("monotone_intervals"),
                                           &find_metric("extremum_offset")};
  std::vector<CellJob> jobs;
  jobs.push_back(profiled_job(drawing(shown), scheme, "pκ, C2", metrics));
  const std::uint64_t seed = context.seed;
  jobs.push_back(
      sweep_job(fmt::format("random triples, seed {}", seed), scheme, random_name, version, triples,
                [scheme, seed](int index, store::CellRecord& cell) { measure(*scheme, triple(seed, index), cell); }));
  return jobs;
}

store::TableRecord numbers(const store::CurveRecord& curve) {
  TableBuilder builder(
      "toy", "The segment in numbers",
      "E_p is the integral of (κ - Q)² over arc length; times the mean chord it does not depend on the "
      "unit. The offset is the arc length from the point to the nearest extremum of curvature over the "
      "local chord.");
  builder.words("quantity").numbers("value");
  for (const auto& [name, column] : {std::pair("E_p (1/length)", "parabola_energy_native_mean"),
                                     std::pair("E_p times mean chord", "parabola_energy_native_scaled_mean"),
                                     std::pair("intervals of monotone curvature", "intervals_per_segment_mean"),
                                     std::pair("offset of the point", "extremum_offset_mean")})
    builder.row({std::string(name), measured(curve, column).value_or(std::nan(""))});
  for (std::size_t i = 0; i < curve.node_t.size(); ++i)
    if (curve.node_t[i] > 0.0 && curve.node_t[i] < 1.0) builder.row({std::string("t of the point"), curve.node_t[i]});
  return builder.table();
}

store::ClaimRecord trend_claim(const store::ExperimentRecord& record) {
  const std::vector<double> shares = study::values(record, "same trend");
  const auto cases = static_cast<double>(shares.size());
  const auto full = static_cast<double>(std::ranges::count(shares, 1.0));
  const double average = cases > 0.0 ? mean(shares) : 0.0;
  return claim(
      "parabola-trend", study::verdict_in_general(average * cases, cases),
      fmt::format("κ' has the sign of the parabola's slope on {:.1f} % of [0, 1] on average", 100.0 * average),
      fmt::format("{:.0f} single segments through random triples (legs of 4 : 1 to 1 : 4), {:.0f} of them with "
                  "the sign of the parabola's slope everywhere; median E_p times mean chord {:.2g}.",
                  cases, full, median(study::values(record, "E_p"))));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.claims = {trend_claim(record)};
  const auto drawn = study::drawn_cell(record, shown, "pκ, C2");
  if (!drawn) return;
  record.tables = {numbers(record.cells[static_cast<std::size_t>(*drawn)].curves.front()),
                   parabola_table(record, "toy-parabola", {*drawn}, 32)};
  record.figures = {{.id = "pkappa-toy",
                     .title = "One segment through three points",
                     .caption = "Left: the curve with its comb. Right: its curvature over t and the parabola with its "
                                "vertex at the middle point's t.",
                     .columns = 2,
                     .panels = {curve_panel({*drawn}, "curve and comb", true),
                                parabola_panel("curvature and parabola", "toy-parabola", "t")}}};
}

}  // namespace

Experiment pkappa_toy_experiment() {
  return {.id = "pkappa-toy",
          .title = "One segment (Wang 2024, Fig. 5)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
