// Yoshida 2022, Fig. 10: what it costs to make a chain of G1 segments G2.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "datasets/drawing.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/continuity.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using study::count_of, study::Findings, study::Key, study::Notes, study::Quantity, study::Row, study::Table;

constexpr std::string_view about =
    "Chains of segments with six control curvatures each. With G1 data a segment knows its neighbours' tangents but "
    "not their curvatures, which jump at the joints. In the paper control curvatures at the joints are moved by hand "
    "until the chain is G2; here each joint is given one curvature for both sides, and the second and the last but "
    "one control of every segment are solved for: the chain is G2 by construction. The tangents are given with the "
    "points (stand-ins; the paper prints none), so that both chains have the same. What it costs: extrema of curvature "
    "inside segments that had none.";

// ---- what is measured

constexpr std::string_view before = "auto=false,continuity=g1", after = "auto=false,continuity=g2";
constexpr double visible = 1e-3;  ///< jump of curvature, relative

const Key control{"control"};
const Quantity tried = count_of("chains"), solved = count_of("solved"), segments = count_of("segments");
const Quantity intervals_before = count_of("intervals before"), intervals_after = count_of("intervals after");
// Relative to 1 / length where the curvature is slight, and that is quadrature.
const Quantity jump_before{"jump before", "1", Method::sampled}, jump_after{"jump after", "1", Method::sampled};
/// Of a control curvature, times the mean chord; the controls come from a solver.
const Quantity moved{"control moved", "1", Method::sampled};

Input chain_of(const std::vector<std::array<double, 3>>& points) {
  Input input;
  for (const auto& [x, y, degrees] : points) {
    input.points.emplace_back(x, y);
    input.options.push_back({.tangent = degrees * std::numbers::pi / 180.0});
  }
  return input;
}

Drawing drawing(std::string id, Input input) {
  Drawing drawing;
  drawing.id = std::move(id);
  drawing.curves = {std::move(input)};
  return drawing;
}

/// Points x, y and the direction there in degrees.
std::vector<Drawing> chains(const Context& context) {
  if (!context.datasets.empty()) return study::drawings_or(context, {});
  return {drawing("chain of two", chain_of({{0, 0, 75}, {4, 3, 5}, {8, 0.5, -60}})),
          drawing("chain of three", chain_of({{0, 0, 80}, {3, 3.2, 10}, {7, 2.2, -35}, {9, -1, -80}})),
          drawing("wave", chain_of({{0, 0, 60}, {3, 1.6, 0}, {6, 0, -45}, {9, -1.2, 10}, {12, 1, 55}}))};
}

std::vector<double> controls_of_segment(const Segment& segment) {
  const ExactForm exact = segment.exact();
  const auto* form = std::get_if<IntrinsicForm>(&exact);
  return form == nullptr ? std::vector<double>{} : form->control_curvatures;
}

int intervals(const Curve& curve) {
  int count = 0;
  for (const SegmentPtr& segment : curve.segments())
    count += 1 + static_cast<int>(curvature_extrema(*segment).at.size());
  return count;
}

void measure(const Uses& uses, const Input& input, Notes& notes) {
  const Fit g1 = uses.schemes[0]->fit(input), g2 = uses.schemes[1]->fit(input);
  const bool both = study::solved(g1) && study::solved(g2);
  notes.row({}, {tried(1), solved(both ? 1 : 0)});
  if (!both) return;
  const double chord = mean_chord(input);
  for (const JointJump& jump : joint_jumps(*g1.curve, input)) notes.put(jump_before(jump.curvature));
  for (const JointJump& jump : joint_jumps(*g2.curve, input))
    notes.put(jump_after(std::max(0.0, jump.curvature - jump.curvature_uncertainty)));
  notes.row(
      {}, {segments(g2.curve->size()), intervals_before(intervals(*g1.curve)), intervals_after(intervals(*g2.curve))});
  for (int i = 0; i < g1.curve->size(); ++i) {
    const auto was = controls_of_segment(g1.curve->segment(i)), is = controls_of_segment(g2.curve->segment(i));
    for (std::size_t k = 0; k < std::min(was.size(), is.size()); ++k)
      notes.row({control(k + 1)}, {moved(std::abs(is[k] - was[k]) * chord)});
  }
}

void measure_chains(const Uses& uses, Notes& notes) {
  for (const Input& input : uses.drawings.front().curves) measure(uses, input, notes);
}

Fit chain_fit(const Uses& uses) { return uses.schemes.front()->fit(uses.drawings.front().curves.front()); }

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr g1 = context.registry.parse(fmt::format("intrinsic:{}", before)),
                  g2 = context.registry.parse(fmt::format("intrinsic:{}", after));
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : chains(context)) {
    for (const auto& [kind, scheme] : {std::pair("G1", g1), std::pair("G2", g2)})
      draw<chain_fit>(jobs, {.work = "chain", .schemes = {scheme}, .drawings = {drawing}},
                      fmt::format("{}, {}", drawing.id, kind), kind);
    jobs.push_back(study::numbers_job<measure_chains>(
        {.work = "g1-to-g2",
         .schemes = {g1, g2},
         .drawings = {drawing},
         .metrics = {&find_metric("continuity"), &find_metric("monotone_intervals")}}));
  }
  return jobs;
}

// ---- what follows

std::vector<std::string> chain_names(const Findings& found) {
  return found.rows().where_row([](const Row& row) { return row.has(tried); }).words_of(study::key::dataset);
}

Table chain_table(const Findings& found) {
  Table table("chains", "From G1 to G2",
              "Jumps of curvature at joints are relative; intervals of monotone curvature are counted segment by "
              "segment. Move: of a control curvature, times the mean chord.");
  table.words("chain").counts("segments").numbers("largest jump, G1").numbers("largest jump, G2");
  table.counts("intervals, G1").counts("intervals, G2").numbers("largest move").numbers("mean move");
  for (const std::string& chain : chain_names(found)) {
    const study::Rows rows = found.rows().where({study::key::dataset(chain)});
    table.row({chain, rows.total(segments), rows.largest(jump_before), rows.largest(jump_after),
               rows.total(intervals_before), rows.total(intervals_after), rows.largest(moved), rows.mean(moved)});
  }
  return table;
}

Table control_table(const Findings& found) {
  Table table("controls", "How much each control curvature moves", "Over all segments, times the mean chord.");
  table.counts("control").counts("segments").numbers("mean move").numbers("largest move");
  for (const auto& [k, rows] : found.rows().by(control))
    table.row({std::get<double>(k), rows.size(), rows.mean(moved), rows.largest(moved)});
  return table;
}

void claim_g2(Findings& found) {
  const study::Rows& rows = found.rows();
  const study::Tally seen = study::tally_of(rows.values(jump_before), [](double j) { return j > visible; });
  found.by_construction(
      "g1-made-g2",
      {fmt::format("largest relative jump of curvature {:.2g}, before {:.2g}", rows.largest(jump_after),
                   rows.largest(jump_before)),
       fmt::format("A joint is given one curvature for both sides, where the paper moves controls by hand. {:.0f} of "
                   "{:.0f} chains solved, {:.0f} joints, {:.0f} of which jumped visibly before; intervals of monotone "
                   "curvature {:.0f} before and {:.0f} after.",
                   rows.total(solved), rows.total(tried), seen.cases, seen.agree, rows.total(intervals_before),
                   rows.total(intervals_after))});
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{.id = "intrinsic-g1-to-g2",
                             .title = "Chains of segments, G1 and G2",
                             .caption =
                                 "With the tangents alone, and with one curvature on both sides of every "
                                 "joint. Right: curvature, control curvatures (squares), knots (ticks).",
                             .columns = 4,
                             .panels = {}};
  for (const std::string& chain : chain_names(found)) {
    for (const std::string kind : {"G1", "G2"})
      add_curve_panel(figure, found, fmt::format("{}, {}", chain, kind), fmt::format("{}, {}", chain, kind));
    for (const std::string kind : {"G1", "G2"})
      add_curvature_panel(figure, found, fmt::format("{}, {}", chain, kind), kind);
  }
  return figure;
}

void conclude(Findings& found) {
  found.add(chain_table(found));
  found.add(control_table(found));
  found.add(figure(found));
  claim_g2(found);
}

}  // namespace

Experiment intrinsic_g1_to_g2_experiment() {
  return study::experiment({.id = "intrinsic-g1-to-g2",
                            .title = "G1 segments made G2 (Yoshida 2022, Fig. 10)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"g1-made-g2"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
