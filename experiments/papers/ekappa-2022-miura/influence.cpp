// Miura 2022, Sect. 3: does the influence of one point die out along the curve?
#include "experiments/papers/ekappa-2022-miura/influence.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/distance.hpp"
#include "experiments/study/jobs.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench::miura {
namespace {

using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Table, study::Tally;

/// Influence is followed over so many spans.
constexpr int farthest = 8;
/// "Near the point": up to the third span from it.
constexpr int near = 3;
/// Points of a curve that are tried.
constexpr int points_tried = 4;
/// Larger curves are left out, where every fit takes long.
constexpr int most_points = 100;
constexpr double moved_by = 0.05;  ///< of the mean chord
/// What counts as a noticeable change of the curve: this part of the displacement.
constexpr double noticeable = 0.01;

/// Without 0.85: there is nothing to change.
constexpr std::array<Shape, 3> influence_shapes{figure_shapes[0], figure_shapes[1], figure_shapes[3]};

// ---- what is measured

const Key change_key{"change"}, span_key{"span"};
constexpr std::string_view raising = "a changed", moving = "moved";
const Quantity influence{"influence", "1", Method::sampled};

/// A fit and its spans, which changed fits are compared with.
struct Reference {
  Fit fit;
  std::vector<Span> parts;
};

/// The largest deviation at each distance from the point, over `unit`, or over the largest of all if `unit` is 0.
/// NaN where the curve has no such span.
void put_influence(Notes& notes, std::string_view change, const Shape& shape, const Reference& before, const Fit& after,
                   int point, double unit) {
  if (!study::solved(after)) return;
  const bool closed = after.input.closed;
  const auto deviations = span_deviations(before.parts, spans(*after.curve), closed);
  if (!deviations) return;
  const double scale = unit > 0.0 ? unit : std::ranges::max(*deviations);
  if (!(scale > 0.0)) return;
  for (int span = 1;
       const double largest : study::largest_by_distance(before.parts, *deviations, point, closed, farthest))
    notes.row({change_key(change), shape_key(shape.words), point_key(point), span_key(span++)},
              {influence(largest / scale)});
}

/// One a_i set to 0.85, and one point moved, on a curve that has the shape's a elsewhere.
void measure_shape(const Scheme& scheme, const Input& input, const Shape& shape, Notes& notes) {
  Reference plain{scheme.fit(with_raised(input, {})), {}};
  if (!study::solved(plain.fit)) return;
  plain.parts = spans(*plain.fit.curve);
  const double step = moved_by * mean_chord(input);
  const int first = input.closed ? 0 : 1, inner = input.closed ? input.size() : input.size() - 2;
  for (const int k : evenly(inner, points_tried)) {
    const int point = first + k;
    put_influence(notes, raising, shape, plain, scheme.fit(with_raised(input, {point})), point, 0.0);
    for (const double angle : {0.0, 0.5 * std::numbers::pi}) {
      Input moved = plain.fit.input;
      moved.points[static_cast<std::size_t>(point)] += step * Vec2(std::cos(angle), std::sin(angle));
      put_influence(notes, moving, shape, plain, scheme.fit(moved), point, step);
    }
  }
}

/// The schemes: influence_shapes.
void measure(const Uses& uses, const Input& input, Notes& notes) {
  if (input.size() < 2 * near + 2 || input.size() > most_points) return;
  for (std::size_t k = 0; k < influence_shapes.size(); ++k)
    measure_shape(*uses.schemes[k], input, influence_shapes[k], notes);
}

// ---- what follows

std::vector<double> influences(const Findings& found, std::string_view change, const Shape& shape, int span) {
  return defined(found.rows().where({change_key(change), shape_key(shape.words), span_key(span)}).values(influence));
}

Tally felt(const std::vector<double>& influences) {
  return study::tally_of(influences, [](double x) { return x > noticeable; });
}

/// The factor by which the median influence falls from one span to the next, from distance 1 to `farthest`.
double decay(const Findings& found, std::string_view change, const Shape& shape) {
  const double ratio = median(influences(found, change, shape, farthest)) / median(influences(found, change, shape, 1));
  return std::pow(ratio, 1.0 / (farthest - 1));
}

Panel influence_panel(const std::string& column) {
  return Panel::graph("influence", "span", {column}, column + " influence")
      .series("case")
      .log_y()
      .labels("distance in spans", column + " influence");
}

}  // namespace

Input with_raised(Input input, const std::set<int>& points) {
  input.options.assign(input.points.size(), {});
  for (const int point : points) input.options[static_cast<std::size_t>(point)].a = raised_a;
  return input;
}

CellJob influence_job(const Registry& registry, const Drawing& drawing) {
  std::vector<SchemePtr> schemes;
  schemes.reserve(influence_shapes.size());
  for (const Shape& shape : influence_shapes) schemes.push_back(cubic(registry, shape.a));
  return study::curves_job<measure>({.work = "influence of a point",
                                     .schemes = std::move(schemes),
                                     .drawings = {drawing},
                                     .metrics = {&find_metric("locality")}});
}

Table influence_table(const Findings& found) {
  Table table("influence", "Influence of one point along the curve",
              "Deviation of the curve by distance from the point in spans (1: the two beside it). a changed: "
              "one a set to 0.85, over the largest deviation. Moved: by 5 % of the mean chord in x or y, "
              "over that displacement. Curves of 8 to 100 points of all drawings, up to four points each.");
  table.words("case").counts("span").counts("curves").numbers("median").numbers("largest").counts("above 1 %");
  for (const std::string_view change : {raising, moving})
    for (const Shape& shape : influence_shapes)
      for (int span = 1; span <= farthest; ++span) {
        const std::vector<double> all = influences(found, change, shape, span);
        table.row({fmt::format("{}, a = {}", change, shape.words), span, all.size(), median(all), largest(all),
                   felt(all).agree});
      }
  return table;
}

store::FigureRecord influence_figure() {
  return {.id = "ekappa-local-shape-influence",
          .title = "How the influence of one point dies out",
          .caption =
              "One a changed to 0.85, relative to the largest deviation; and one point moved by 5 % of "
              "the mean chord, relative to the displacement. Over all drawings: median and largest.",
          .columns = 2,
          .panels = {influence_panel("median"), influence_panel("largest")}};
}

void claim_influence(Findings& found) {
  Tally far;
  std::vector<std::string> decays;
  for (const Shape& shape : influence_shapes) {
    for (int span = near + 1; span <= farthest; ++span) far += felt(influences(found, moving, shape, span));
    decays.push_back(fmt::format("{:.2g} and {:.2g} at a = {}", decay(found, moving, shape),
                                 decay(found, raising, shape), shape.words));
  }
  const Tally quiet{far.misses(), far.cases};
  found.judge("local-influence", quiet,
              {fmt::format("median influence falls per span by a factor of (point moved, one a changed) {}",
                           fmt::join(decays, ", ")),
               fmt::format("Points moved by 5 % of the mean chord on curves of 8 to 100 points of all drawings: in "
                           "{} of the spans that are four to eight spans away the curve moves by at most 1 % of the "
                           "displacement. It is never strictly local: the equations couple all points.",
                           quiet.words())});
}

}  // namespace kappabench::miura
