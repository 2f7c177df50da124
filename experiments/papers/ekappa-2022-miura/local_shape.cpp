#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/verdicts.hpp"
#include "metrics/correspondence.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {

using namespace miura;
using namespace study;

namespace {

constexpr std::string_view about =
    "Every point may have its own a. Miura et al. raise it at one, two and three points of a closed curve, and at the "
    "wing tips of a bird or everywhere else. Measured here: whether the curvature rises at every raised point, and how "
    "fast the effect of a changed a, and of a moved point, dies out along the curve.";

constexpr double kappa_a = 2.0 / 3.0, raised_a = 0.85, wing_a = 0.95;
/// Fig. 5: the points that are raised in turn.
constexpr std::array<int, 3> raised_in_turn{0, 2, 3};
/// The bird's wing tips, points of its first curve (datasets/points/bird.txt).
constexpr std::array<int, 2> wing_tips{6, 15};
constexpr std::string_view bird = "bird", boomerang = "five-boomerang";
constexpr std::string_view kappa_label = "κ-curve", tips_label = "a = 0.95 at the wing tips",
                           rest_label = "a = 0.95 everywhere else";

/// Influence is followed over so many spans.
constexpr int farthest = 8;
/// Points of a curve that are tried for the influence of a change.
constexpr int points_tried = 4;
/// The influence is not followed on larger curves, where every fit takes long.
constexpr int most_points = 100;
constexpr double moved_by = 0.05;  ///< of the mean chord
/// What counts as a noticeable change of the curve: this part of the displacement.
constexpr double noticeable = 0.01;
/// "Near the point": up to the third span from it.
constexpr int near = 3;

std::string raised_label(std::size_t points) {
  return fmt::format("a = 0.85 at {} point{}", points, points == 1 ? "" : "s");
}

bool is_tip(int curve, int point) { return curve == 0 && std::ranges::find(wing_tips, point) != wing_tips.end(); }

void add_bird_jobs(std::vector<CellJob>& jobs, const Registry& registry, const Drawing& drawing) {
  const SchemePtr scheme = cubic(registry, kappa_a);
  jobs.push_back(drawn_job(drawing, registry.create("kappa"), std::string(kappa_label)));
  jobs.push_back(drawn_job(with_shape_at(drawing, wing_a, is_tip), scheme, std::string(tips_label)));
  jobs.push_back(drawn_job(with_shape_at(drawing, wing_a, [](int c, int p) { return !is_tip(c, p); }), scheme,
                           std::string(rest_label)));
}

void add_raised_jobs(std::vector<CellJob>& jobs, const Registry& registry, const Drawing& drawing) {
  jobs.push_back(drawn_job(drawing, registry.create("kappa"), std::string(kappa_label)));
  for (std::size_t count = 1; count <= raised_in_turn.size(); ++count) {
    const auto raised = [count](int, int point) {
      return std::ranges::find(raised_in_turn.begin(), raised_in_turn.begin() + static_cast<std::ptrdiff_t>(count),
                               point) != raised_in_turn.begin() + static_cast<std::ptrdiff_t>(count);
    };
    jobs.push_back(drawn_job(with_shape_at(drawing, raised_a, raised), cubic(registry, kappa_a), raised_label(count)));
  }
}

// ---- measured over all drawings

Input with_a(Input input, double a, const std::set<int>& points) {
  input.options.assign(input.points.size(), {});
  for (const int point : points) input.options[static_cast<std::size_t>(point)].a = a;
  return input;
}

const Node* node_of(const Curve& curve, int point) {
  const auto found = std::ranges::find(curve.nodes(), point, &Node::point);
  return found == curve.nodes().end() ? nullptr : &*found;
}

/// Raises a at sets of one, two and three points that lie evenly around the curve and counts where |kappa| rises.
void measure_raising(const Registry& registry, const Input& input, store::CellRecord& cell) {
  const SchemePtr scheme = cubic(registry, kappa_a);
  const Fit plain = scheme->fit(with_a(input, raised_a, {}));
  if (!solved(plain)) return;
  const int n = input.size(), first = input.closed ? 0 : 1, inner = input.closed ? n : n - 2;
  for (const int count : {1, 2, 3}) {
    if (inner < count) continue;
    for (const int start : evenly(inner, points_tried)) {
      std::set<int> raised;
      for (int k = 0; k < count; ++k) raised.insert(first + (start + k * inner / count) % inner);
      const Fit fit = scheme->fit(with_a(input, raised_a, raised));
      put(cell, "raised fits", 1.0);
      if (!solved(fit)) {
        put(cell, "raised fits without a solution", 1.0);
        continue;
      }
      for (const int point : raised) {
        const Node *before = node_of(*plain.curve, point), *after = node_of(*fit.curve, point);
        if (before == nullptr || after == nullptr || before->has(kappa::marks::at_inflection) ||
            after->has(kappa::marks::at_inflection))
          continue;
        const double ratio = curvature_at(*fit.curve, *after) / curvature_at(*plain.curve, *before);
        put(cell,
            fmt::format("{} of {} at {}", before->has(kappa::marks::pinned) ? "pinned ratio" : "ratio", count, "0.85"),
            ratio);
      }
    }
  }
}

/// A fit and its spans, which changed fits are compared with.
struct Reference {
  Fit fit;
  std::vector<Span> parts;
};

/// The largest deviation at each distance from the point, over `unit`, or over the largest of all if `unit` is 0.
/// NaN where the curve has no such span.
void put_influence(store::CellRecord& cell, const std::string& what, const Reference& before, const Fit& after,
                   int point, double unit) {
  if (!solved(after)) return;
  const bool closed = after.input.closed;
  const auto deviations = span_deviations(before.parts, spans(*after.curve), closed);
  if (!deviations) return;
  const std::vector<double> influence = largest_by_distance(before.parts, *deviations, point, closed, farthest);
  const double scale = unit > 0.0 ? unit : std::ranges::max(*deviations);
  if (!(scale > 0.0)) return;
  for (int d = 1; d <= farthest; ++d)
    put(cell, fmt::format("{} {}", what, d), influence[static_cast<std::size_t>(d) - 1] / scale, Method::sampled);
}

/// One a_i set to 0.85, and one point moved, on a curve that has `a` elsewhere.
void measure_influence(const Registry& registry, const Input& input, const Shape& shape, store::CellRecord& cell) {
  if (input.size() < 2 * near + 2 || input.size() > most_points) return;
  const SchemePtr scheme = cubic(registry, shape.a);
  Reference plain{scheme->fit(with_a(input, raised_a, {})), {}};
  if (!solved(plain.fit)) return;
  plain.parts = spans(*plain.fit.curve);
  const double step = moved_by * mean_chord(input);
  const int first = input.closed ? 0 : 1, inner = input.closed ? input.size() : input.size() - 2;
  for (const int k : evenly(inner, points_tried)) {
    const int point = first + k;
    put_influence(cell, fmt::format("a changed at {}", shape.words), plain,
                  scheme->fit(with_a(input, raised_a, {point})), point, 0.0);
    for (const double angle : {0.0, 0.5 * std::numbers::pi}) {
      Input moved = plain.fit.input;
      moved.points[static_cast<std::size_t>(point)] += step * Vec2(std::cos(angle), std::sin(angle));
      put_influence(cell, fmt::format("moved at {}", shape.words), plain, scheme->fit(moved), point, step);
    }
  }
}

/// Without 0.85: there is nothing to change.
constexpr std::array<Shape, 3> influence_shapes{figure_shapes[0], figure_shapes[1], figure_shapes[3]};

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  const Registry& registry = context.registry;
  for (const Drawing& drawing : drawings_or(context, {boomerang, bird}))
    drawing.id == bird ? add_bird_jobs(jobs, registry, drawing) : add_raised_jobs(jobs, registry, drawing);
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(study_job(drawing, cubic(registry, kappa_a), "local shape", 1,
                             [&registry](const Drawing& points, store::CellRecord& cell) {
                               for (const Input& input : points.curves) {
                                 measure_raising(registry, input, cell);
                                 for (const Shape& shape : influence_shapes)
                                   measure_influence(registry, input, shape, cell);
                               }
                             }));
  return jobs;
}

// ---- from the finished cells

double count_above(const std::vector<double>& values, double bound) {
  return static_cast<double>(std::ranges::count_if(values, [bound](double v) { return v > bound; }));
}

/// Ratios of |kappa| at raised points, by their number and whether the point was pinned before.
std::vector<double> raised(const store::ExperimentRecord& record, int count, bool pinned) {
  return values(record, fmt::format("{} of {} at 0.85", pinned ? "pinned ratio" : "ratio", count));
}

store::TableRecord raising_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "raising", "Raising a from 2/3 to 0.85 at some points",
      "|κ| at raised points over |κ| of the κ-curve there, over all drawings; up to four choices of the "
      "points on each curve. Pinned: the point was at an end of its segment in the κ-curve.");
  builder.words("raised points").words("in the κ-curve").counts("cases").counts("|κ| rises");
  builder.numbers("median ratio").numbers("largest ratio");
  for (const int count : {1, 2, 3})
    for (const bool pinned : {false, true}) {
      const auto ratios = raised(record, count, pinned);
      builder.row({fmt::format("{}", count), std::string(pinned ? "pinned" : "inside its segment"),
                   static_cast<double>(ratios.size()), count_above(ratios, 1.0), median(ratios), largest(ratios)});
    }
  return builder.table();
}

/// Fig. 5 in numbers: the points of each drawn single curve.
store::TableRecord points_table(const store::ExperimentRecord& record) {
  TableBuilder builder("points", "Curvature at the points of the drawn curves",
                       "|κ| at each point of the drawings that are one curve, per drawing unit.");
  builder.words("drawing").words("curve").counts("point").numbers("|κ|", "1/length");
  for (const store::CellRecord& cell : record.cells) {
    if (cell.curves.size() != 1) continue;
    const store::CurveRecord& curve = cell.curves.front();
    for (std::size_t i = 0; i < curve.node_point.size(); ++i)
      builder.row({cell.dataset, cell.label, static_cast<double>(curve.node_point[i]), std::abs(curve.node_kappa[i])});
  }
  return builder.table();
}

constexpr std::string_view change = "a changed", movement = "moved";

std::vector<double> influence(const store::ExperimentRecord& record, std::string_view what, const Shape& shape, int d) {
  std::vector<double> found;
  std::ranges::copy_if(values(record, fmt::format("{} at {} {}", what, shape.words, d)), std::back_inserter(found),
                       [](double v) { return !std::isnan(v); });
  return found;
}

store::TableRecord influence_table(const store::ExperimentRecord& record) {
  TableBuilder builder("influence", "Influence of one point along the curve",
                       "Deviation of the curve by distance from the point in spans (1: the two beside it). a changed: "
                       "one a set to 0.85, over the largest deviation. Moved: by 5 % of the mean chord in x or y, "
                       "over that displacement. Curves of 8 to 100 points of all drawings, up to four points each.");
  builder.words("case").counts("span").counts("curves").numbers("median").numbers("largest");
  builder.counts("above 1 %");
  for (const std::string_view what : {change, movement})
    for (const Shape& shape : influence_shapes)
      for (int d = 1; d <= farthest; ++d) {
        const auto found = influence(record, what, shape, d);
        builder.row({fmt::format("{}, a = {}", what, shape.words), static_cast<double>(d),
                     static_cast<double>(found.size()), median(found), largest(found), count_above(found, noticeable)});
      }
  return builder.table();
}

/// The factor by which the median influence falls from one span to the next, from distance 1 to `farthest`.
double decay(const store::ExperimentRecord& record, std::string_view what, const Shape& shape) {
  const double ratio = median(influence(record, what, shape, farthest)) / median(influence(record, what, shape, 1));
  return std::pow(ratio, 1.0 / (farthest - 1));
}

std::optional<store::FigureRecord> row_figure(const store::ExperimentRecord& record, const std::string& dataset) {
  const bool flying = drawn_cell(record, dataset, tips_label).has_value();
  store::FigureRecord figure{.id = "ekappa-local-shape-" + dataset,
                             .title = fmt::format("Local control of curvature: {}", dataset),
                             .caption = {},
                             .columns = 4,
                             .panels = {}};
  figure.caption = flying ? "The κ-curve; a = 0.95 at the wing tips and 2/3 elsewhere; the roles reversed; the κ-curve."
                          : fmt::format(
                                "The κ-curve, and a = 0.85 at points {} (counted from 0) in turn, 2/3 at the "
                                "others. Curvature combs to one scale.",
                                fmt::join(raised_in_turn, ", "));
  std::vector<std::string> labels{std::string(kappa_label)};
  if (flying) {
    labels.insert(labels.end(), {std::string(tips_label), std::string(rest_label), std::string(kappa_label)});
  } else {
    for (std::size_t count = 1; count <= raised_in_turn.size(); ++count) labels.push_back(raised_label(count));
  }
  for (const std::string& label : labels) {
    const auto index = drawn_cell(record, dataset, label);
    if (!index) return std::nullopt;
    store::PanelRecord panel{.kind = "curve", .title = label, .cells = {*index}};
    panel.comb = !flying;
    panel.joints = !flying;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

store::FigureRecord influence_figure() {
  store::PanelRecord panel{.kind = "graph", .title = "median influence"};
  panel.table = "influence";
  panel.x = "span";
  panel.x_label = "distance in spans";
  panel.y = {"median"};
  panel.y_label = "median influence";
  panel.series = "case";
  panel.log_y = true;
  store::PanelRecord worst = panel;
  worst.title = "largest influence";
  worst.y = {"largest"};
  worst.y_label = "largest influence";
  return {.id = "ekappa-local-shape-influence",
          .title = "How the influence of one point dies out",
          .caption =
              "One a changed to 0.85, relative to the largest deviation; and one point moved by 5 % of "
              "the mean chord, relative to the displacement. Over all drawings: median and largest.",
          .columns = 2,
          .panels = {panel, worst}};
}

store::ClaimRecord raising_claim(const store::ExperimentRecord& record) {
  double cases = 0.0, rises = 0.0, pinned_cases = 0.0, pinned_rises = 0.0;
  for (const int count : {1, 2, 3})
    for (const bool pinned : {false, true}) {
      const auto ratios = raised(record, count, pinned);
      (pinned ? pinned_cases : cases) += static_cast<double>(ratios.size());
      (pinned ? pinned_rises : rises) += count_above(ratios, 1.0);
    }
  return claim("raising-a-sharpens-locally", verdict_in_general(rises + pinned_rises, cases + pinned_cases),
               fmt::format("|κ| rises at {} raised points", share(rises + pinned_rises, cases + pinned_cases)),
               fmt::format("a from 2/3 to 0.85 at one, two or three points, up to four choices on every curve of all "
                           "drawings: {} where the κ-curve peaks inside the segment, {} where the point is pinned. "
                           "{:.0f} of {:.0f} fits had no solution.",
                           share(rises, cases), share(pinned_rises, pinned_cases),
                           total(record, "raised fits without a solution"), total(record, "raised fits")));
}

/// |kappa| at a point of the first curve; NaN without it.
double curvature_at_point(const store::ExperimentRecord& record, std::string_view label, int point) {
  const auto index = drawn_cell(record, bird, label);
  if (index && !record.cells[static_cast<std::size_t>(*index)].curves.empty()) {
    const store::CurveRecord& curve = record.cells[static_cast<std::size_t>(*index)].curves.front();
    for (std::size_t i = 0; i < curve.node_point.size(); ++i)
      if (curve.node_point[i] == point) return std::abs(curve.node_kappa[i]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Empty when the bird was not drawn.
std::optional<store::ClaimRecord> wing_claim(const store::ExperimentRecord& record) {
  const auto index = drawn_cell(record, bird, kappa_label);
  if (!index || record.cells[static_cast<std::size_t>(*index)].curves.empty()) return std::nullopt;
  const store::CurveRecord& outline = record.cells[static_cast<std::size_t>(*index)].curves.front();
  double tips = 0.0, rounder = 0.0, rest = 0.0, sharper = 0.0;
  for (const int point : outline.node_point) {
    const bool sharper_reversed =
        curvature_at_point(record, rest_label, point) > curvature_at_point(record, tips_label, point);
    if (is_tip(0, point)) {
      tips += 1.0;
      rounder += sharper_reversed ? 0.0 : 1.0;
    } else {
      rest += 1.0;
      sharper += sharper_reversed ? 1.0 : 0.0;
    }
  }
  const auto at_tips = [&](std::string_view label) {
    return fmt::format("{:.3g} and {:.3g}", curvature_at_point(record, label, wing_tips[0]),
                       curvature_at_point(record, label, wing_tips[1]));
  };
  return claim(
      "wing-tips", verdict_in_general(rounder + sharper, tips + rest),
      fmt::format("a = 0.95 at the tips against everywhere else: sharper at {:.0f} of {:.0f} tips, blunter at {} "
                  "other points",
                  rounder, tips, share(sharper, rest)),
      fmt::format("|κ| at the wing tips of our bird, per drawing unit: {} in the κ-curve, {} with a = 0.95 "
                  "there, {} reversed.",
                  at_tips(kappa_label), at_tips(tips_label), at_tips(rest_label)));
}

store::ClaimRecord influence_claim(const store::ExperimentRecord& record) {
  double far = 0.0, quiet = 0.0;
  for (const Shape& shape : influence_shapes)
    for (int d = near + 1; d <= farthest; ++d) {
      const auto found = influence(record, movement, shape, d);
      far += static_cast<double>(found.size());
      quiet += static_cast<double>(found.size()) - count_above(found, noticeable);
    }
  std::string decays;
  for (const Shape& shape : influence_shapes)
    decays += fmt::format("{}{:.2g} and {:.2g} at a = {}", decays.empty() ? "" : ", ", decay(record, movement, shape),
                          decay(record, change, shape), shape.words);
  return claim("local-influence", verdict_in_general(quiet, far),
               fmt::format("median influence falls per span by a factor of (point moved, one a changed) {}", decays),
               fmt::format("Points moved by 5 % of the mean chord on curves of 8 to 100 points of all drawings: in "
                           "{} of the spans that are four to eight spans away the curve moves by at most 1 % of the "
                           "displacement. It is never strictly local: the equations couple all points.",
                           share(quiet, far)));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {points_table(record), raising_table(record), influence_table(record)};
  for (const std::string& dataset : drawn_datasets(record))
    if (auto figure = row_figure(record, dataset)) record.figures.push_back(std::move(*figure));
  record.figures.push_back(influence_figure());
  record.claims = {raising_claim(record), influence_claim(record)};
  if (auto wings = wing_claim(record)) record.claims.push_back(std::move(*wings));
}

}  // namespace

Experiment ekappa_local_shape_experiment() {
  return {.id = "ekappa-local-shape",
          .title = "Local control of curvature (Miura 2022, Figs. 5 and 6)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
