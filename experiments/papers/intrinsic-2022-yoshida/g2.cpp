#include "experiments/run/experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/summaries.hpp"
#include "schemes/curve/jet.hpp"
#include "schemes/intrinsic/viable_region.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {

using namespace yoshida;
using namespace intrinsic;

namespace {

constexpr std::string_view about =
    "Pairs of end curvatures for theta_e = pi/9, theta_d = pi/3, in place of the four of Fig. 8, which the paper marks "
    "but does not print: one high above the border, one at the side of the region, one just above the border, and one "
    "that the Bezier curvature function reaches. The automatic family solves each; so do, or do not, the fixed knots "
    "of Fig. 6. That the previous method, a Bezier curvature function with the ends' curvatures given, has no monotone "
    "curve at a pair is shown by trying all its rising control curvatures: none ends near the end point. Towards the "
    "border curvature becomes a step; how much of the length it needs to rise from 10 to 90 % of its range is given "
    "for data ever nearer to it.";

constexpr int version = 1;

struct Pair {
  std::string_view name, where;
  double start, end;
};
/// Stand-ins for a, b, c and d of Fig. 8(a); c is the one whose curvature is like a step, Fig. 8(d).
constexpr std::array<Pair, 4> pairs{{{"a", "high above the border", 0.05, 8.0},
                                     {"b", "at the right side", 0.6, 4.0},
                                     {"c", "just above the border", 0.3, 1.62},
                                     {"d", "inside Fig. 6(a)", 0.2, 2.4}}};
/// Stand-ins for Fig. 7: in the regions of Fig. 6(a) and (e).
constexpr std::array<Pair, 2> examples{
    {{"Fig. 7(a)", "inside Fig. 6(a)", 0.1, 2.2}, {"Fig. 7(b)", "inside Fig. 6(e)", 0.1, 6.0}}};
constexpr std::array nearness{1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6};  ///< xi - 1

StandardData data_of(const Pair& pair) { return with_curvatures(angles_of_figure_6(), pair.start, pair.end); }

Settings example_settings(std::size_t i) { return families_of_figure_6()[i == 0 ? 0 : 4].settings(); }

/// How far the ends of curves by the Bezier curvature function stay away from the data: all rising second and third
/// control curvatures on a fine grid, the length from the turning (Eq. (8)). A monotone solution would show as a
/// distance of about the grid's step.
struct NearestEnd {
  double distance;  ///< chords
  double step;      ///< the largest distance between ends of neighbouring choices near there
};

NearestEnd nearest_end(const StandardData& data) {
  constexpr int steps = 160;
  const double low = *data.start_curvature, high = *data.end_curvature;
  const auto end_of = [&](double second, double third) -> Vec2 {
    const BSplineBasis basis = uniform_basis(3, 4);
    const double mean = 0.25 * (low + second + third + high);
    return IntrinsicSegment(
               {Vec2::Zero(), -data.chord_angle, data.turning / mean, 3, basis.knots, {low, second, third, high}})
        .jet(1.0, 0)
        .position();
  };
  const auto value = [&](int i) { return low + (high - low) * i / steps; };
  NearestEnd best{HUGE_VAL, 0.0};
  int second = 0, third = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = i; j <= steps; ++j) {
      const double distance = (end_of(value(i), value(j)) - Vec2::UnitX()).norm();
      if (distance < best.distance) {
        best.distance = distance;
        second = i;
        third = j;
      }
    }
  const Vec2 there = end_of(value(second), value(third));
  for (const auto& [i, j] :
       {std::pair{second - 1, third}, {second + 1, third}, {second, third - 1}, {second, third + 1}})
    if (i >= 0 && i <= j && j <= steps) best.step = std::max(best.step, (end_of(value(i), value(j)) - there).norm());
  return best;
}

/// Share of the length on which curvature rises from 10 to 90 % of its range.
double transition(const StandardCurve& curve) {
  const IntrinsicSegment segment(form_of(curve, 0.0));
  const double low = curve.controls.front(), high = curve.controls.back();
  // Monotone: bisection.
  const auto where = [&](double part) {
    double from = 0.0, to = 1.0;
    for (int i = 0; i < 60; ++i) {
      const double t = 0.5 * (from + to);
      (curvature(segment.jet(t, 2)) < low + part * (high - low) ? from : to) = t;
    }
    return from;
  };
  return where(0.9) - where(0.1);
}

void measure_pair(const Pair& pair, store::CellRecord& cell) {
  const StandardData data = data_of(pair);
  study::put(cell, "xi", viability(data).nesting);
  for (const FixedFamily& family : families_of_figure_6()) {
    const HermiteFit fit = solve(data, family.settings());
    const std::string column(family.title);
    study::put(cell, column + ": solved", fit.outcome == Outcome::converged ? 1.0 : 0.0);
    study::put(cell, column + ": monotone", rises(fit) ? 1.0 : 0.0);
  }
  const HermiteFit fit = solve(data);
  study::put(cell, "automatic: monotone", rises(fit) ? 1.0 : 0.0);
  study::put(cell, "automatic: controls", fit.curve ? static_cast<double>(fit.curve->controls.size()) : 0.0);
  study::put(cell, "automatic: transition", fit.curve ? transition(*fit.curve) : std::nan(""),
             kappabench::Method::sampled);
  const NearestEnd nearest = nearest_end(data);
  study::put(cell, "nearest end", nearest.distance, kappabench::Method::sampled);
  study::put(cell, "step of ends", nearest.step, kappabench::Method::sampled);
}

/// Ever nearer to the border over the middle of its range.
StandardData near_border(double excess) {
  const StandardData angles = angles_of_figure_6();
  const double half = std::sin(0.5 * (angles.turning - 2.0 * angles.chord_angle));
  const double side = 2.0 * std::abs(half) * std::sqrt(1.0 + excess);
  return with_curvatures(angles, 2.0 * std::sin(angles.chord_angle) - side, 2.0 * std::sin(angles.end_angle()) + side);
}

void measure_border(store::CellRecord& cell) {
  for (const double excess : nearness) {
    const HermiteFit fit = solve(near_border(excess));
    study::put(cell, "excess", excess);
    study::put(cell, "monotone", rises(fit) ? 1.0 : 0.0);
    study::put(cell, "gap", fit.residual, kappabench::Method::sampled);
    study::put(cell, "transition", fit.curve ? transition(*fit.curve) : std::nan(""), kappabench::Method::sampled);
  }
}

std::string dataset_of(const Pair& pair) { return fmt::format("({:g}, {:g})", pair.start, pair.end); }
constexpr std::string_view border_dataset = "towards the border";

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  const auto add = [&jobs](std::vector<CellJob> more) { std::ranges::move(more, std::back_inserter(jobs)); };
  for (const Pair& pair : pairs) {
    add(drawn_jobs(scheme, dataset_of(pair), "curve", version,
                   [pair] { return as_fit(data_of(pair), solve(data_of(pair))); }));
    jobs.push_back(numbers_job(scheme, dataset_of(pair), "pair", version,
                               [pair](store::CellRecord& cell) { measure_pair(pair, cell); }));
  }
  for (std::size_t i = 0; i < examples.size(); ++i)
    add(drawn_jobs(scheme, dataset_of(examples[i]), "curve", version,
                   [i] { return as_fit(data_of(examples[i]), solve(data_of(examples[i]), example_settings(i))); }));
  jobs.push_back(numbers_job(scheme, std::string(border_dataset), "border", version, measure_border));
  return jobs;
}

double value(const store::ExperimentRecord& record, std::string_view column, std::string_view dataset) {
  const std::vector<double> all = study::values(record, column, dataset);
  return all.empty() ? std::nan("") : all.front();
}

store::TableRecord pair_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "pairs", "Four pairs of end curvatures",
      "1 where a monotone solution is found: by the fixed knots and p of Fig. 6 and by the automatic "
      "family. Transition: share of the length on which its curvature rises from 10 to 90 % of its "
      "range. Nearest end: least distance, in chords, from the end point of a curve with a Bezier "
      "curvature function of rising control curvatures, tried on a grid; step: distance of the ends of "
      "neighbouring choices there.");
  builder.words("pair").words("where").numbers("start").numbers("end").numbers("xi");
  for (const FixedFamily& family : families_of_figure_6()) builder.counts(std::string(family.title));
  builder.counts("automatic").numbers("transition").numbers("nearest end").numbers("step");
  for (const Pair& pair : pairs) {
    const std::string dataset = dataset_of(pair);
    if (std::isnan(value(record, "xi", dataset))) continue;
    std::vector<TableBuilder::Cell> row{std::string(pair.name), std::string(pair.where), pair.start, pair.end,
                                        value(record, "xi", dataset)};
    for (const FixedFamily& family : families_of_figure_6())
      row.emplace_back(value(record, fmt::format("{}: monotone", family.title), dataset));
    for (const std::string_view column :
         {"automatic: monotone", "automatic: transition", "nearest end", "step of ends"})
      row.emplace_back(value(record, column, dataset));
    builder.row(row);
  }
  return builder.table();
}

store::TableRecord border_table(const store::ExperimentRecord& record) {
  const auto excess = study::values(record, "excess", border_dataset),
             rising = study::values(record, "monotone", border_dataset),
             missed = study::values(record, "gap", border_dataset),
             width = study::values(record, "transition", border_dataset);
  TableBuilder builder("border", "Towards the border",
                       "The automatic family on the diagonal of the region. Transition: share of the length on which "
                       "curvature rises from 10 to 90 % of its range.");
  builder.numbers("xi - 1").counts("monotone").numbers("gap").numbers("transition");
  for (std::size_t i = 0; i < excess.size(); ++i) builder.row({excess[i], rising[i], missed[i], width[i]});
  return builder.table();
}

store::ClaimRecord previous_claim(const store::ExperimentRecord& record) {
  double cases = 0.0, holds = 0.0;
  std::vector<std::string> lines;
  for (const Pair& pair : pairs) {
    if (pair.name == "d") continue;
    const std::string dataset = dataset_of(pair);
    const double nearest = value(record, "nearest end", dataset);
    if (std::isnan(nearest)) continue;
    cases += 1.0;
    const bool impossible =
        value(record, "(a) m = 4: monotone", dataset) == 0.0 && nearest > 4.0 * value(record, "step of ends", dataset);
    const bool eight =
        value(record, "automatic: monotone", dataset) == 1.0 && value(record, "automatic: controls", dataset) == 8.0;
    holds += impossible && eight ? 1.0 : 0.0;
    lines.push_back(fmt::format("{} {:.2g}", pair.name, nearest));
  }
  return claim("beyond-previous-method", study::verdict_for_all(cases - holds, cases),
               fmt::format("{} pairs out of reach of the Bezier curvature function and solved with eight",
                           study::share(holds, cases)),
               fmt::format("The pairs are stand-ins. Least distance of the end, in chords, over all rising control "
                           "curvatures: {}. At d that method has {} monotone solution.",
                           fmt::join(lines, ", "),
                           value(record, "(a) m = 4: monotone", dataset_of(pairs[3])) == 1.0 ? "a" : "no"));
}

store::ClaimRecord step_claim(const store::ExperimentRecord& record) {
  const auto excess = study::values(record, "excess", border_dataset),
             rising = study::values(record, "monotone", border_dataset),
             width = study::values(record, "transition", border_dataset);
  bool narrows = !excess.empty();
  for (std::size_t i = 0; i < excess.size(); ++i)
    narrows = narrows && rising[i] == 1.0 && (i == 0 || width[i] < width[i - 1]);
  const bool step = narrows && width.back() < 0.05;
  const double c = value(record, "automatic: transition", dataset_of(pairs[2]));
  return claim(
      "like-a-step",
      excess.empty() ? "not reproduced"
      : step         ? "reproduced"
                     : "contradicted",
      excess.empty() ? "nothing measured"
                     : fmt::format("from 10 to 90 % of the range in {:.2g} of the length at xi - 1 = {:g}",
                                   width.back(), excess.back()),
      fmt::format("The automatic family on {} data ever nearer to the border; at c it is {:.2g} of the length. "
                  "A linear curvature has 0.8; a step is what rises in less than 0.05.",
                  excess.size(), c));
}

store::FigureRecord figure(const store::ExperimentRecord& record, std::span<const Pair> shown, std::string id,
                           std::string title, std::string caption) {
  store::FigureRecord figure{.id = std::move(id),
                             .title = std::move(title),
                             .caption = std::move(caption),
                             .columns = static_cast<int>(shown.size()),
                             .panels = {}};
  for (const Pair& pair : shown)
    add_curve_panel(figure, record, dataset_of(pair),
                    pair.name.size() == 1 ? dataset_of(pair) : fmt::format("{}: {}", pair.name, dataset_of(pair)));
  for (const Pair& pair : shown) add_curvature_panel(figure, record, dataset_of(pair), std::string(pair.where));
  return figure;
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {pair_table(record), border_table(record)};
  const std::string below = " Below: curvature over arc length; squares are control curvatures, ticks knots.";
  for (auto drawn :
       {figure(record, pairs, "pairs", "Four pairs of end curvatures",
               "Stand-ins for the points a, b, c, d of Fig. 8(a), by the automatic family." + below),
        figure(record, examples, "examples", "Fixed knots",
               "Stand-ins for Fig. 7: four control curvatures, and six with knots near the ends." + below)})
    if (!drawn.panels.empty()) record.figures.push_back(std::move(drawn));
  record.claims = {previous_claim(record), step_claim(record)};
}

}  // namespace

Experiment intrinsic_g2_experiment() {
  return {.id = "intrinsic-g2",
          .title = "G2 Hermite interpolation (Yoshida 2022, Figs. 7 and 8)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
