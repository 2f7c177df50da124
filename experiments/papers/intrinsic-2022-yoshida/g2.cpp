// Yoshida 2022, Figs. 7 and 8: G2 data that the automatic family meets and others do not, and what curvature becomes
// towards the border of the viable region.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "schemes/curve/jet.hpp"
#include "schemes/intrinsic/viable_region.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using namespace intrinsic;
using kappabench::Method;
using study::count_of, study::Findings, study::Key, study::Notes, study::Quantity, study::Rows, study::Table,
    study::Tally;

constexpr std::string_view about =
    "Pairs of end curvatures for theta_e = pi/9, theta_d = pi/3, in place of the four of Fig. 8, which the paper marks "
    "but does not print: one high above the border, one at the side of the region, one just above the border, and one "
    "that the Bezier curvature function reaches. The automatic family solves each; so do, or do not, the fixed knots "
    "of Fig. 6. That the previous method, a Bezier curvature function with the ends' curvatures given, has no monotone "
    "curve at a pair is shown by trying all its rising control curvatures: none ends near the end point. Towards the "
    "border curvature becomes a step; how much of the length it needs to rise from 10 to 90 % of its range is given "
    "for data ever nearer to it.";

// ---- what is measured

struct Pair {
  std::string_view name, where;
  double start, end;
  std::string_view family = automatic;
};
/// Stand-ins for a, b, c and d of Fig. 8(a); c is the one whose curvature is like a step, Fig. 8(d).
constexpr std::array<Pair, 4> pairs{{{"a", "high above the border", 0.05, 8.0},
                                     {"b", "at the right side", 0.6, 4.0},
                                     {"c", "just above the border", 0.3, 1.62},
                                     {"d", "inside Fig. 6(a)", 0.2, 2.4}}};
/// Stand-ins for Fig. 7: in the regions of Fig. 6(a) and (e).
constexpr std::array<Pair, 2> examples{
    {{"Fig. 7(a)", "inside Fig. 6(a)", 0.1, 2.2, "(a) m = 4"},
     {"Fig. 7(b)", "inside Fig. 6(e)", 0.1, 6.0, "(e) m = 6, p = 1, knots at ends"}}};
constexpr std::array nearness{1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6};  ///< xi - 1

constexpr std::string_view border_dataset = "towards the border";
const Key family{"family"}, excess{"xi - 1"};
const Quantity xi{"xi", "1", Method::exact};
const Quantity solved = count_of("solved"), monotone_found = count_of("monotone"), controls = count_of("controls");
/// Share of the length on which curvature rises from 10 to 90 % of its range.
const Quantity transition{"transition", "1", Method::sampled};
const Quantity nearest{"nearest end", "chord", Method::sampled}, step_of_ends{"step of ends", "chord", Method::sampled};
const Quantity missed{"gap", "1", Method::sampled};

StandardData data_of(const Uses& uses) {
  return with_curvatures(angles_of_figure_6(), uses.numbers.at("start"), uses.numbers.at("end"));
}

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

double transition_of(const StandardCurve& curve) {
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

study::Reading transition_of(const HermiteFit& fit) {
  return transition(fit.curve ? transition_of(*fit.curve) : std::nan(""));
}

void measure_pair(const Uses& uses, Notes& notes) {
  const StandardData data = data_of(uses);
  notes.put(xi(viability(data).nesting));
  for (const FixedFamily& fixed : families_of_figure_6()) {
    const HermiteFit fit = solve(data, fixed.settings());
    notes.row({family(fixed.title)},
              {solved(fit.outcome == Outcome::converged ? 1 : 0), monotone_found(rises(fit) ? 1 : 0)});
  }
  const HermiteFit fit = solve(data);
  notes.row({family(automatic)}, {monotone_found(rises(fit) ? 1 : 0),
                                  controls(fit.curve ? fit.curve->controls.size() : 0), transition_of(fit)});
  const NearestEnd end = nearest_end(data);
  notes.row({}, {nearest(end.distance), step_of_ends(end.step)});
}

/// Ever nearer to the border over the middle of its range.
StandardData near_border(double beyond) {
  const StandardData angles = angles_of_figure_6();
  const double half = std::sin(0.5 * (angles.turning - 2.0 * angles.chord_angle));
  const double side = 2.0 * std::abs(half) * std::sqrt(1.0 + beyond);
  return with_curvatures(angles, 2.0 * std::sin(angles.chord_angle) - side, 2.0 * std::sin(angles.end_angle()) + side);
}

void measure_border(const Uses&, Notes& notes) {
  for (const double near : nearness) {
    const HermiteFit fit = solve(near_border(near));
    notes.row({excess(near)}, {monotone_found(rises(fit) ? 1 : 0), missed(fit.residual), transition_of(fit)});
  }
}

Fit drawn_fit(const Uses& uses) {
  return as_fit(data_of(uses), solve(data_of(uses), settings_of(uses.words.at("family"))));
}

std::string dataset_of(const Pair& pair) { return fmt::format("({:g}, {:g})", pair.start, pair.end); }

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  const auto uses = [&scheme](std::string work, const Pair& pair) {
    return Uses{.work = std::move(work),
                .schemes = {scheme},
                .numbers = {{"start", pair.start}, {"end", pair.end}},
                .words = {{"family", std::string(pair.family)}}};
  };
  for (const Pair& pair : pairs) {
    draw<drawn_fit>(jobs, uses("G2 curve", pair), dataset_of(pair));
    jobs.push_back(study::numbers_job<measure_pair>(uses("pair", pair), dataset_of(pair)));
  }
  for (const Pair& pair : examples) draw<drawn_fit>(jobs, uses("G2 curve", pair), dataset_of(pair));
  jobs.push_back(
      study::numbers_job<measure_border>({.work = "border", .schemes = {scheme}}, std::string(border_dataset)));
  return jobs;
}

// ---- what follows

Rows rows_of(const Findings& found, const Pair& pair) {
  return found.rows().where({study::key::dataset(dataset_of(pair))});
}

/// The one number of a pair, or of one of its families; NaN if it was not measured.
double value(const Rows& rows, const Quantity& what) { return rows.mean(what); }
double value(const Rows& rows, const Quantity& what, std::string_view by) {
  return rows.where({family(by)}).mean(what);
}

Table pair_table(const Findings& found) {
  Table table("pairs", "Four pairs of end curvatures",
              "1 where a monotone solution is found: by the fixed knots and p of Fig. 6 and by the automatic "
              "family. Transition: share of the length on which its curvature rises from 10 to 90 % of its "
              "range. Nearest end: least distance, in chords, from the end point of a curve with a Bezier "
              "curvature function of rising control curvatures, tried on a grid; step: distance of the ends of "
              "neighbouring choices there.");
  table.words("pair").words("where").numbers("start").numbers("end").numbers("xi");
  for (const FixedFamily& fixed : families_of_figure_6()) table.counts(std::string(fixed.title));
  table.counts("automatic").numbers("transition").numbers("nearest end").numbers("step");
  for (const Pair& pair : pairs) {
    const Rows rows = rows_of(found, pair);
    if (rows.empty()) continue;
    std::vector<study::TableValue> row{pair.name, pair.where, pair.start, pair.end, value(rows, xi)};
    for (const FixedFamily& fixed : families_of_figure_6()) row.emplace_back(value(rows, monotone_found, fixed.title));
    row.emplace_back(value(rows, monotone_found, automatic));
    for (const Quantity& what : {transition, nearest, step_of_ends}) row.emplace_back(value(rows, what));
    table.row(row);
  }
  return table;
}

Table border_table(const Findings& found) {
  Table table("border", "Towards the border",
              "The automatic family on the diagonal of the region. Transition: share of the length on which "
              "curvature rises from 10 to 90 % of its range.");
  table.numbers("xi - 1").counts("monotone").numbers("gap").numbers("transition");
  for (const auto& [near, rows] : found.rows().by(excess))
    table.row({std::get<double>(near), value(rows, monotone_found), value(rows, missed), value(rows, transition)});
  return table;
}

/// That there are such pairs: three that we chose show it, if the search for a curve by the previous method fails.
void claim_previous(Findings& found) {
  constexpr std::string_view bezier = "(a) m = 4";
  Tally tally;
  std::vector<std::string> lines;
  for (const Pair& pair : std::span(pairs).first(3)) {
    const Rows rows = rows_of(found, pair);
    if (rows.empty()) continue;
    const double end = value(rows, nearest);
    const bool impossible = value(rows, monotone_found, bezier) == 0.0 && end > 4.0 * value(rows, step_of_ends);
    const bool eight = value(rows, monotone_found, automatic) == 1.0 && value(rows, controls) == 8.0;
    tally.add(impossible && eight);
    lines.push_back(fmt::format("{} {:.2g}", pair.name, end));
  }
  const bool reached = value(rows_of(found, pairs[3]), monotone_found, bezier) == 1.0;
  found.judge(
      "beyond-previous-method", tally,
      {fmt::format("{} pairs out of reach of the Bezier curvature function and solved with eight", tally.words()),
       fmt::format("The pairs are ours, chosen outside Fig. 6(a). Least distance of the end, in chords, over all "
                   "rising control curvatures: {}. At d that method has {} monotone solution.",
                   fmt::join(lines, ", "), reached ? "a" : "no")});
}

/// A step is a limit: the share of the length in which curvature rises is a power of the distance from the border.
void claim_step(Findings& found) {
  constexpr double near_border = 0.1;
  std::vector<double> near, width, exponents;
  for (const auto& [distance, rows] : found.rows().by(excess)) {
    near.push_back(std::get<double>(distance));
    width.push_back(value(rows, monotone_found) == 1.0 ? value(rows, transition) : undefined);
  }
  for (std::size_t i = 1; i < near.size(); ++i)
    if (near[i - 1] <= near_border)
      exponents.push_back(std::log(width[i] / width[i - 1]) / std::log(near[i] / near[i - 1]));
  const bool known = !exponents.empty() && std::ranges::none_of(exponents, [](double e) { return std::isnan(e); });
  study::Interval power{undefined, undefined};
  if (known) power = {std::ranges::min(exponents), std::ranges::max(exponents)};
  found.judge(
      "like-a-step", power,
      {fmt::format("curvature rises in a share of the length that falls as (xi - 1) to the power of {:.3g} to {:.3g}",
                   power.low, power.high),
       fmt::format(
           "From 10 to 90 % of the range, by the automatic family at xi - 1 = {}: shares {:.2g}; exponents between "
           "neighbours from {} on. At c it is {:.2g}. A linear curvature has 0.8.",
           fmt::join(near, ", "), fmt::join(width, ", "), near_border, value(rows_of(found, pairs[2]), transition))});
}

void add_figure(Findings& found, std::span<const Pair> shown, std::string id, std::string title, std::string caption) {
  store::FigureRecord figure{.id = std::move(id),
                             .title = std::move(title),
                             .caption = std::move(caption) +
                                        " Below: curvature over arc length; squares are control curvatures, ticks "
                                        "knots.",
                             .columns = static_cast<int>(shown.size()),
                             .panels = {}};
  for (const Pair& pair : shown)
    add_curve_panel(figure, found, dataset_of(pair),
                    pair.name.size() == 1 ? dataset_of(pair) : fmt::format("{}: {}", pair.name, dataset_of(pair)));
  for (const Pair& pair : shown) add_curvature_panel(figure, found, dataset_of(pair), std::string(pair.where));
  found.add(std::move(figure));
}

void conclude(Findings& found) {
  found.add(pair_table(found));
  found.add(border_table(found));
  add_figure(found, pairs, "pairs", "Four pairs of end curvatures",
             "Stand-ins for the points a, b, c, d of Fig. 8(a), by the automatic family.");
  add_figure(found, examples, "examples", "Fixed knots",
             "Stand-ins for Fig. 7: four control curvatures, and six with knots near the ends.");
  claim_previous(found);
  claim_step(found);
}

}  // namespace

Experiment intrinsic_g2_experiment() {
  return study::experiment({.id = "intrinsic-g2",
                            .title = "G2 Hermite interpolation (Yoshida 2022, Figs. 7 and 8)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"beyond-previous-method", "like-a-step"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
