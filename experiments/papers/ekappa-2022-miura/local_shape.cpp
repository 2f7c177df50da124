// Miura 2022, Figs. 5 and 6: does a larger a at some points sharpen the curve there, and how far does a change reach?
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/papers/ekappa-2022-miura/influence.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "Every point may have its own a. Miura et al. raise it at one, two and three points of a closed curve, and at the "
    "wing tips of a bird or everywhere else. Measured here: whether the curvature rises at every raised point, and how "
    "fast the effect of a changed a, and of a moved point, dies out along the curve.";

constexpr double wing_a = 0.95;
/// Fig. 5: the points that are raised in turn.
constexpr std::array<int, 3> raised_in_turn{0, 2, 3};
/// The bird's wing tips, points of its first curve (datasets/points/bird.txt).
constexpr std::array<int, 2> wing_tips{6, 15};
constexpr std::string_view bird = "bird", boomerang = "five-boomerang";
constexpr std::string_view kappa_label = "κ-curve", tips_label = "a = 0.95 at the wing tips",
                           rest_label = "a = 0.95 everywhere else";

std::string raised_label(std::size_t points) {
  return fmt::format("a = 0.85 at {} point{}", points, points == 1 ? "" : "s");
}

bool is_tip(int curve, int point) { return curve == 0 && std::ranges::find(wing_tips, point) != wing_tips.end(); }

// ---- what is measured

/// Points of a curve that are tried as the first of those to raise.
constexpr int starts_tried = 4;

const Key raised_points{"raised points"}, in_kappa_curve{"in the kappa-curve"};
constexpr std::string_view inside = "inside its segment", pinned = "pinned";
const Quantity unsolved = study::count_of("raised fit without a solution");
/// A row a raised point.
const Quantity ratio{"curvature over that of the kappa-curve", "1", Method::exact};

const Node* node_of(const Curve& curve, int point) {
  const auto found = std::ranges::find(curve.nodes(), point, &Node::point);
  return found == curve.nodes().end() ? nullptr : &*found;
}

/// Raises a at sets of one, two and three points that lie evenly around the curve, and looks where |kappa| rises.
void measure_raising(const Uses& uses, const Input& input, Notes& notes) {
  const Scheme& scheme = *uses.schemes.front();
  const Fit plain = scheme.fit(with_raised(input, {}));
  if (!study::solved(plain)) return;
  const int n = input.size(), first = input.closed ? 0 : 1, inner = input.closed ? n : n - 2;
  for (const int count : {1, 2, 3}) {
    if (inner < count) continue;
    for (const int start : evenly(inner, starts_tried)) {
      std::set<int> raised;
      for (int k = 0; k < count; ++k) raised.insert(first + (start + k * inner / count) % inner);
      const Fit fit = scheme.fit(with_raised(input, raised));
      notes.put(unsolved(study::solved(fit) ? 0 : 1));
      if (!study::solved(fit)) continue;
      for (const int point : raised) {
        const Node *before = node_of(*plain.curve, point), *after = node_of(*fit.curve, point);
        if (before == nullptr || after == nullptr || before->has(kappa::marks::at_inflection) ||
            after->has(kappa::marks::at_inflection))
          continue;
        notes.row({raised_points(count), in_kappa_curve(before->has(kappa::marks::pinned) ? pinned : inside),
                   point_key(point)},
                  {ratio(curvature_at(*fit.curve, *after) / curvature_at(*plain.curve, *before))});
      }
    }
  }
}

/// Fig. 6.
void add_bird_jobs(std::vector<CellJob>& jobs, const Registry& registry, const Drawing& drawing) {
  const SchemePtr scheme = cubic(registry, kappa_a);
  const auto not_tip = [](int curve, int point) { return !is_tip(curve, point); };
  jobs.push_back(fit_job(drawing, registry.create("kappa"), {}, std::string(kappa_label)));
  jobs.push_back(fit_job(with_shape_at(drawing, wing_a, is_tip), scheme, {}, std::string(tips_label)));
  jobs.push_back(fit_job(with_shape_at(drawing, wing_a, not_tip), scheme, {}, std::string(rest_label)));
}

/// Fig. 5.
void add_raised_jobs(std::vector<CellJob>& jobs, const Registry& registry, const Drawing& drawing) {
  jobs.push_back(fit_job(drawing, registry.create("kappa"), {}, std::string(kappa_label)));
  for (std::size_t count = 1; count <= raised_in_turn.size(); ++count) {
    const auto raised = [count](int, int point) {
      return std::ranges::count(std::span(raised_in_turn).first(count), point) > 0;
    };
    jobs.push_back(
        fit_job(with_shape_at(drawing, raised_a, raised), cubic(registry, kappa_a), {}, raised_label(count)));
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Registry& registry = context.registry;
  for (const Drawing& drawing : study::drawings_or(context, {boomerang, bird}))
    drawing.id == bird ? add_bird_jobs(jobs, registry, drawing) : add_raised_jobs(jobs, registry, drawing);
  for (const Drawing& drawing : study::drawings_of(context)) {
    jobs.push_back(study::curves_job<measure_raising>(
        {.work = "raised a", .schemes = {cubic(registry, kappa_a)}, .drawings = {drawing}}));
    jobs.push_back(influence_job(registry, drawing));
  }
  return jobs;
}

// ---- what follows

bool rises(double r) { return r > 1.0; }

Table raising_table(const Findings& found) {
  Table table("raising", "Raising a from 2/3 to 0.85 at some points",
              "|κ| at raised points over |κ| of the κ-curve there, over all drawings; up to four choices of the "
              "points on each curve. Pinned: the point was at an end of its segment in the κ-curve.");
  table.words("raised points").words("in the κ-curve").counts("cases").counts("|κ| rises");
  table.numbers("median ratio").numbers("largest ratio");
  for (const int count : {1, 2, 3})
    for (const std::string_view was : {inside, pinned}) {
      const Rows rows = found.rows().where({raised_points(count), in_kappa_curve(was)});
      const Tally rising = study::tally_of(rows.values(ratio), rises);
      table.row({std::to_string(count), was, rising.cases, rising.agree, rows.median(ratio), rows.largest(ratio)});
    }
  return table;
}

/// Fig. 5 in numbers: the points of each drawn single curve.
Table points_table(const Findings& found) {
  Table table("points", "Curvature at the points of the drawn curves",
              "|κ| at each point of the drawings that are one curve, per drawing unit.");
  table.words("drawing").words("curve").counts("point").numbers("|κ|", "1/length");
  for (const store::CellRecord& cell : found.cells()) {
    if (cell.curves.size() != 1) continue;
    const store::CurveRecord& curve = cell.curves.front();
    for (std::size_t i = 0; i < curve.node_point.size(); ++i)
      table.row({cell.dataset, cell.label, curve.node_point[i], std::abs(curve.node_kappa[i])});
  }
  return table;
}

store::FigureRecord row_figure(const Findings& found, const std::string& drawing) {
  const bool flying = found.find(drawing, tips_label).has_value();
  store::FigureRecord figure{
      .id = "ekappa-local-shape-" + drawing,
      .title = "Local control of curvature: " + drawing,
      .caption = flying ? "The κ-curve; a = 0.95 at the wing tips and 2/3 elsewhere; the roles reversed; the κ-curve."
                        : fmt::format("The κ-curve, and a = 0.85 at points {} (counted from 0) in turn, 2/3 at the "
                                      "others. Curvature combs to one scale.",
                                      fmt::join(raised_in_turn, ", ")),
      .columns = 4};
  std::vector<std::string> labels{std::string(kappa_label), raised_label(1), raised_label(2), raised_label(3)};
  if (flying) labels = {labels[0], std::string(tips_label), std::string(rest_label), labels[0]};
  for (const std::string& label : labels)
    if (const auto cell = found.find(drawing, label))
      figure.panels.push_back(flying ? Panel::curves({*cell}, label).without_joints()
                                     : Panel::curves({*cell}, label).comb());
  return figure;
}

void claim_raising(Findings& found) {
  const auto of = [&](std::string_view was) {
    return study::tally_of(found.rows().where({in_kappa_curve(was)}).values(ratio), rises);
  };
  const Tally all = study::tally_of(found.rows().values(ratio), rises);
  const Tally failed = study::tally_of(found.rows().values(unsolved));
  found.judge("raising-a-sharpens-locally", all,
              {fmt::format("|κ| rises at {} raised points", all.words()),
               fmt::format("a from 2/3 to 0.85 at one, two or three points, up to four choices on every curve of all "
                           "drawings: {} where the κ-curve peaks inside the segment, {} where the point is pinned. "
                           "{:.0f} of {:.0f} fits had no solution.",
                           of(inside).words(), of(pinned).words(), failed.agree, failed.cases)});
}

/// The bird's outline, drawn with this label; null without it.
const store::CurveRecord* outline(const Findings& found, std::string_view label) {
  const auto cell = found.find(bird, label);
  return cell ? found.curve(*cell) : nullptr;
}

/// |kappa| at a point of the bird's outline; NaN without it.
double curvature_at_point(const Findings& found, std::string_view label, int point) {
  const store::CurveRecord* curve = outline(found, label);
  for (std::size_t i = 0; curve != nullptr && i < curve->node_point.size(); ++i)
    if (curve->node_point[i] == point) return std::abs(curve->node_kappa[i]);
  return undefined;
}

/// Nothing is said when the bird was not drawn.
void claim_wing_tips(Findings& found) {
  const store::CurveRecord* curve = outline(found, kappa_label);
  if (curve == nullptr) return;
  Tally tips, rest;  // sharper at the tips, blunter elsewhere, with a = 0.95 at the tips than reversed
  for (const int point : curve->node_point) {
    const bool sharper_reversed =
        curvature_at_point(found, rest_label, point) > curvature_at_point(found, tips_label, point);
    is_tip(0, point) ? tips.add(!sharper_reversed) : rest.add(sharper_reversed);
  }
  const auto at_tips = [&](std::string_view label) {
    return fmt::format("{:.3g} and {:.3g}", curvature_at_point(found, label, wing_tips[0]),
                       curvature_at_point(found, label, wing_tips[1]));
  };
  Tally all = tips;
  all += rest;
  found.judge(
      "wing-tips", all,
      {fmt::format("a = 0.95 at the tips against everywhere else: sharper at {:.0f} of {:.0f} tips, blunter at {} "
                   "other points",
                   tips.agree, tips.cases, rest.words()),
       fmt::format("|κ| at the wing tips of our bird, per drawing unit: {} in the κ-curve, {} with a = 0.95 "
                   "there, {} reversed.",
                   at_tips(kappa_label), at_tips(tips_label), at_tips(rest_label))});
}

void conclude(Findings& found) {
  for (const Table& table : {points_table(found), raising_table(found), influence_table(found)}) found.add(table);
  for (const std::string& drawing : found.drawn()) found.add(row_figure(found, drawing));
  found.add(influence_figure());
  claim_raising(found);
  claim_influence(found);
  claim_wing_tips(found);
}

}  // namespace

Experiment ekappa_local_shape_experiment() {
  return study::experiment({.id = "ekappa-local-shape",
                            .title = "Local control of curvature (Miura 2022, Figs. 5 and 6)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"raising-a-sharpens-locally", "local-influence", "wing-tips"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
