#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "datasets/drawing.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/study/summaries.hpp"
#include "metrics/continuity.hpp"
#include "schemes/curve/exact_curvature.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {

using namespace yoshida;

namespace {

constexpr std::string_view about =
    "Chains of segments with six control curvatures each. With G1 data a segment knows its neighbours' tangents but "
    "not their curvatures, which jump at the joints. In the paper control curvatures at the joints are moved by hand "
    "until the chain is G2; here each joint is given one curvature for both sides, and the second and the last but "
    "one control of every segment are solved for. The tangents are given with the points (stand-ins; the paper prints "
    "none), so that both chains have the same. What it costs: extrema of curvature inside segments that had none.";

constexpr int version = 1;
constexpr std::string_view before = "auto=false,continuity=g1", after = "auto=false,continuity=g2";
constexpr double visible = 1e-3;   ///< jump of curvature, relative
constexpr double rounding = 1e-9;  ///< of a jump that is none

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

void measure(const Scheme& one, const Scheme& other, const Drawing& drawing, store::CellRecord& cell) {
  for (const Input& input : drawing.curves) {
    const Fit g1 = one.fit(input), g2 = other.fit(input);
    study::put(cell, "chains", 1.0);
    if (!study::solved(g1) || !study::solved(g2)) continue;
    study::put(cell, "solved", 1.0);
    const double chord = mean_chord(input);
    for (const JointJump& jump : joint_jumps(*g1.curve, chord)) study::put(cell, "jump before", jump.curvature);
    for (const JointJump& jump : joint_jumps(*g2.curve, chord)) {
      study::put(cell, "joints", 1.0);
      study::put(cell, "jump after", std::max(0.0, jump.curvature - jump.curvature_uncertainty));
      study::put(cell, "angle after", jump.angle);
    }
    study::put(cell, "segments", g2.curve->size());
    study::put(cell, "intervals before", intervals(*g1.curve));
    study::put(cell, "intervals after", intervals(*g2.curve));
    for (int i = 0; i < g1.curve->size(); ++i) {
      const auto was = controls_of_segment(g1.curve->segment(i)), is = controls_of_segment(g2.curve->segment(i));
      for (std::size_t k = 0; k < std::min(was.size(), is.size()); ++k)
        study::put(cell, fmt::format("control {} moved", k + 1), std::abs(is[k] - was[k]) * chord);
    }
  }
}

std::string dataset_of(const Drawing& drawing, bool g2) { return fmt::format("{}, {}", drawing.id, g2 ? "G2" : "G1"); }

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr one = context.registry.parse(fmt::format("intrinsic:{}", before)),
                  other = context.registry.parse(fmt::format("intrinsic:{}", after));
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : chains(context)) {
    for (const bool g2 : {false, true}) {
      const SchemePtr scheme = g2 ? other : one;
      std::ranges::move(drawn_jobs(scheme, dataset_of(drawing, g2), g2 ? "G2" : "G1", version,
                                   [scheme, input = drawing.curves.front()] { return scheme->fit(input); }),
                        std::back_inserter(jobs));
    }
    jobs.push_back(
        study::study_job(drawing, one, "g1-to-g2", version,
                         [one, other](const Drawing& d, store::CellRecord& cell) { measure(*one, *other, d, cell); }));
  }
  return jobs;
}

std::vector<std::string> datasets_of(const store::ExperimentRecord& record) {
  std::vector<std::string> names;
  for (const store::CellRecord& cell : record.cells)
    if (measured(cell, "chains")) names.push_back(cell.dataset);
  return names;
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "chains", "From G1 to G2",
      "Jumps of curvature at joints are relative; intervals of monotone curvature are counted segment by "
      "segment. Move: of a control curvature, times the mean chord.");
  builder.words("chain").counts("segments").numbers("largest jump, G1").numbers("largest jump, G2");
  builder.counts("intervals, G1").counts("intervals, G2").numbers("largest move").numbers("mean move");
  for (const std::string& dataset : datasets_of(record)) {
    std::vector<double> moves;
    for (int k = 1; k <= 6; ++k)
      std::ranges::copy(study::values(record, fmt::format("control {} moved", k), dataset), std::back_inserter(moves));
    builder.row(
        {dataset, study::total(record, "segments", dataset), largest(study::values(record, "jump before", dataset)),
         largest(study::values(record, "jump after", dataset)), study::total(record, "intervals before", dataset),
         study::total(record, "intervals after", dataset), largest(moves), mean(moves)});
  }
  return builder.table();
}

store::TableRecord control_table(const store::ExperimentRecord& record) {
  TableBuilder builder("controls", "How much each control curvature moves", "Over all segments, times the mean chord.");
  builder.counts("control").counts("segments").numbers("mean move").numbers("largest move");
  for (int k = 1; k <= 6; ++k) {
    const auto moves = study::values(record, fmt::format("control {} moved", k));
    if (!moves.empty())
      builder.row({static_cast<double>(k), static_cast<double>(moves.size()), mean(moves), largest(moves)});
  }
  return builder.table();
}

store::ClaimRecord g2_claim(const store::ExperimentRecord& record) {
  const double chains = study::total(record, "chains"), solved = study::total(record, "solved");
  const auto jumps = study::values(record, "jump after"), was = study::values(record, "jump before");
  const auto failing = static_cast<double>(std::ranges::count_if(jumps, [](double j) { return !(j <= rounding); }));
  const auto seen = std::ranges::count_if(was, [](double j) { return j > visible; });
  return claim("g1-made-g2", study::verdict_for_all(failing + chains - solved, chains),
               fmt::format("largest relative jump of curvature {:.2g}, before {:.2g}", largest(jumps), largest(was)),
               fmt::format("{:.0f} of {:.0f} chains solved, {} joints, {} of which jumped visibly before; intervals of "
                           "monotone curvature {:.0f} before and {:.0f} after.",
                           solved, chains, jumps.size(), seen, study::total(record, "intervals before"),
                           study::total(record, "intervals after")));
}

std::vector<store::FigureRecord> figures(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "intrinsic-g1-to-g2",
                             .title = "Chains of segments, G1 and G2",
                             .caption =
                                 "With the tangents alone, and with one curvature on both sides of every "
                                 "joint. Right: curvature, control curvatures (squares), knots (ticks).",
                             .columns = 4,
                             .panels = {}};
  for (const std::string& dataset : datasets_of(record)) {
    for (const std::string_view kind : {"G1", "G2"})
      add_curve_panel(figure, record, fmt::format("{}, {}", dataset, kind), fmt::format("{}, {}", dataset, kind));
    for (const std::string_view kind : {"G1", "G2"})
      add_curvature_panel(figure, record, fmt::format("{}, {}", dataset, kind), std::string(kind));
  }
  return figure.panels.empty() ? std::vector<store::FigureRecord>{} : std::vector{std::move(figure)};
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record), control_table(record)};
  record.figures = figures(record);
  record.claims = {g2_claim(record)};
}

}  // namespace

Experiment intrinsic_g1_to_g2_experiment() {
  return {.id = "intrinsic-g1-to-g2",
          .title = "G1 segments made G2 (Yoshida 2022, Fig. 10)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
