// Miura 2022, Figs. 11 and 12: are trigonometric curves more rounded than cubic Bernstein ones, and do both approach?
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/correspondence.hpp"
#include "schemes/curve/jet.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::Findings, study::Key, study::KeyIs, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table,
    study::Tally;

constexpr std::string_view about =
    "The same points by cubic Bernstein and by quadratic trigonometric segments. Miura et al. call the latter more "
    "rounded, and say that both approach the polygon of the points as a grows. Roundness is measured by the largest "
    "over the mean magnitude of curvature, by the total variation of curvature, and by the distance from the polygon.";

/// The values of a at which both families are measured, and two more at which the trigonometric one is gentler.
constexpr std::array<Shape, 4> bernstein_shapes{{{2.0 / 3.0, "2/3"}, {0.75, "0.75"}, {0.9, "0.9"}, {0.99, "0.99"}}};
constexpr std::array<Shape, 6> trigonometric_shapes{
    {{0.55, "0.55"}, {0.6, "0.6"}, bernstein_shapes[0], bernstein_shapes[1], bernstein_shapes[2], bernstein_shapes[3]}};
constexpr std::size_t gentler = trigonometric_shapes.size() - bernstein_shapes.size();
/// The Bernstein curve that the k-th trigonometric one is compared with: the same a; for the gentler two the κ-curve.
const Shape& counterpart(std::size_t k) { return bernstein_shapes[k < gentler ? 0 : k - gentler]; }

constexpr std::string_view kappa_label = "κ-curve";
std::string bernstein(const Shape& shape) { return fmt::format("Bernstein, a = {}", shape.words); }
std::string trigonometric(const Shape& shape) { return fmt::format("trigonometric, a = {}", shape.words); }

// ---- what is measured

/// Curves of more points are left out: with a = 0.55 they can take many seconds, for one row among hundreds.
constexpr int most_points = 100;

/// A row for each curve and spline, "Bernstein, a = 0.75"; NaN without a solution.
const Key spline{"spline"};
const Quantity peak_over_mean{"peak over mean curvature", "1", Method::sampled};
const Quantity variation{"total variation times length", "1", Method::sampled};
const Quantity to_polygon{"distance to the polygon", "1", Method::sampled};
/// A row for each curve and a.
const Quantity apart{"distance between the families", "1", Method::sampled};

double distance_to_chord(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 chord = to - from;
  const double t = chord.squaredNorm() > 0.0 ? std::clamp((p - from).dot(chord) / chord.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - (from + t * chord)).norm();
}

/// Largest distance of the curve from the polygon of its points, span by span.
double distance_to_polygon(const std::vector<Span>& spans, const Input& input) {
  double largest = 0.0;
  const Vec2 &first = input.points.front(), &last = input.points.back();
  for (const Span& span : spans) {
    const Vec2& from = span.from == no_point ? first : input.points[static_cast<std::size_t>(span.from)];
    const Vec2& to = span.to == no_point ? last : input.points[static_cast<std::size_t>(span.to)];
    for (const Vec2& p : span.samples) largest = std::max(largest, distance_to_chord(p, from, to));
  }
  return largest;
}

/// Peak over mean of |kappa|, and the total variation of kappa times the length, from 33 samples a segment and the
/// nodes, where the peaks are.
struct Roundness {
  double peak_over_mean;
  double variation;
};

Roundness roundness(const Curve& curve) {
  const CurveSamples samples = sample(curve, 33, 2);
  double peak = 0.0, varies = 0.0, turning = 0.0, length = 0.0;
  for (const Node& node : curve.nodes()) peak = std::max(peak, curvature_at(curve, node));
  double before = curvature(curve.closed() ? samples.jets.back() : samples.jets.front());
  for (std::size_t i = 0; i < samples.jets.size(); ++i) {
    const Jet& jet = samples.jets[i];
    const double kappa = curvature(jet);
    peak = std::max(peak, std::abs(kappa));
    varies += std::abs(kappa - before);
    before = kappa;
    if (i % samples.t.size() == 0) continue;
    const Jet& last = samples.jets[i - 1];
    length += (jet.position() - last.position()).norm();
    turning += std::abs(std::atan2(cross(last.d[1], jet.d[1]), last.d[1].dot(jet.d[1])));
  }
  return {turning > 0.0 ? peak * length / turning : undefined, varies * length};
}

/// Puts the numbers of one fit, and returns its spans.
std::vector<Span> measure_fit(const Fit& fit, int number, const std::string& label, Notes& notes) {
  const bool curve = study::solved(fit);
  const Roundness round = curve ? roundness(*fit.curve) : Roundness{undefined, undefined};
  std::vector<Span> parts = curve ? spans(*fit.curve) : std::vector<Span>{};
  const double polygon = curve ? distance_to_polygon(parts, fit.input) / mean_chord(fit.input) : undefined;
  notes.row({curve_key(number), spline(label)},
            {peak_over_mean(round.peak_over_mean), variation(round.variation), to_polygon(polygon)});
  return parts;
}

/// The schemes: Bernstein, then trigonometric, in the order of their shapes.
void measure_curve(const Uses& uses, const Input& input, int number, Notes& notes) {
  std::vector<std::vector<Span>> first, second;
  for (const Shape& shape : bernstein_shapes)
    first.push_back(measure_fit(uses.schemes[first.size()]->fit(input), number, bernstein(shape), notes));
  for (const Shape& shape : trigonometric_shapes)
    second.push_back(
        measure_fit(uses.schemes[first.size() + second.size()]->fit(input), number, trigonometric(shape), notes));
  for (std::size_t k = 0; k < first.size(); ++k) {
    const auto &one = first[k], &other = second[gentler + k];
    const bool both = !one.empty() && !other.empty();
    const double distance = both ? deviation(one, other, input.closed) / mean_chord(input) : undefined;
    notes.row({curve_key(number), shape_key(bernstein_shapes[k].words)},
              {apart(std::isfinite(distance) ? distance : undefined)});
  }
}

void measure(const Uses& uses, Notes& notes) {
  for (int number = 0; const Input& input : uses.drawings.front().curves) {
    if (input.size() <= most_points) measure_curve(uses, input, number, notes);
    ++number;
  }
}

/// Fig. 11, its top row and its bottom row.
std::vector<std::string> top_row() {
  return {std::string(kappa_label), bernstein(bernstein_shapes[0]), bernstein(bernstein_shapes[1]),
          bernstein(bernstein_shapes[2])};
}
const std::array<Shape, 4> bottom_row{trigonometric_shapes[0], trigonometric_shapes[1], trigonometric_shapes[3],
                                      trigonometric_shapes[4]};

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  std::vector<SchemePtr> schemes;
  schemes.reserve(bernstein_shapes.size() + trigonometric_shapes.size());
  for (const Shape& shape : bernstein_shapes) schemes.push_back(cubic(context.registry, shape.a));
  for (const Shape& shape : trigonometric_shapes) schemes.push_back(miura::trigonometric(context.registry, shape.a));
  for (const Drawing& drawing : study::drawings_or(context, {"five-drop", "christmas-tree"})) {
    jobs.push_back(fit_job(drawing, context.registry.create("kappa"), {}, std::string(kappa_label)));
    for (std::size_t k = 0; k < 3; ++k)
      jobs.push_back(fit_job(drawing, schemes[k], {}, bernstein(bernstein_shapes[k])));
    for (const Shape& shape : bottom_row)
      jobs.push_back(fit_job(drawing, miura::trigonometric(context.registry, shape.a), {}, trigonometric(shape)));
  }
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(study::numbers_job<measure>(
        {.work = "bases", .schemes = schemes, .drawings = {drawing}, .metrics = {&find_metric("locality")}}));
  return jobs;
}

// ---- what follows

/// On how many curves the quantity is smaller with the first key than with the second, where both are defined.
Tally smaller(const Findings& found, const Quantity& what, const KeyIs& first, const KeyIs& second) {
  Tally tally;
  for (const auto& [one, other] : found.rows().pairs(what, first, second))
    if (!std::isnan(one) && !std::isnan(other)) tally.add(one < other);
  return tally;
}

/// The k-th trigonometric curve against its counterpart.
Tally less(const Findings& found, const Quantity& what, std::size_t k) {
  return smaller(found, what, spline(trigonometric(trigonometric_shapes[k])), spline(bernstein(counterpart(k))));
}

/// "smaller" the other way around, on the same curves.
Tally others(const Tally& tally) { return {tally.misses(), tally.cases}; }

Rows of(const Findings& found, const std::string& label) { return found.rows().where({spline(label)}); }

Table family_table(const Findings& found) {
  Table table("families", "Roundness of both families",
              "Medians over the curves of up to 100 points of all drawings, as far as solved. Peak over mean is the "
              "largest over the mean |κ| along the curve (1 for a circle); variation is the total variation of κ times "
              "the length; the distance is over the mean chord, largest along a curve.");
  table.words("family").words("a").numbers("a as a number").counts("curves").numbers("peak over mean");
  table.numbers("variation").numbers("distance to the polygon");
  const auto row = [&](std::string_view family, const Shape& shape, const Rows& rows) {
    table.row({family, shape.words, shape.a, defined(rows.values(to_polygon)).size(), rows.median(peak_over_mean),
               rows.median(variation), rows.median(to_polygon)});
  };
  for (const Shape& shape : bernstein_shapes) row("Bernstein", shape, of(found, bernstein(shape)));
  for (const Shape& shape : trigonometric_shapes) row("trigonometric", shape, of(found, trigonometric(shape)));
  return table;
}

Table comparison_table(const Findings& found) {
  Table table("comparison", "Trigonometric against Bernstein",
              "Counts of the curves on which the trigonometric one is rounder: a smaller number, or farther "
              "from the polygon. The first two rows compare with the κ-curve, as Fig. 11 does.");
  table.words("trigonometric a").words("Bernstein a").counts("curves").counts("smaller peak over mean");
  table.counts("smaller variation").counts("farther from the polygon");
  for (std::size_t k = 0; k < trigonometric_shapes.size(); ++k) {
    const Tally peak = less(found, peak_over_mean, k);
    table.row({trigonometric_shapes[k].words, counterpart(k).words, peak.cases, peak.agree,
               less(found, variation, k).agree, less(found, to_polygon, k).misses()});
  }
  return table;
}

Table distance_table(const Findings& found) {
  Table table("distances", "Distances as a grows",
              "Largest distance along a curve over the mean chord: from the polygon of the points, and between "
              "the families at the same a at equal parts of the arc length from point to point.");
  table.words("distance").words("a").numbers("a as a number").counts("curves").numbers("median").numbers("largest");
  const auto row = [&](std::string_view words, const Shape& shape, const std::vector<double>& distances) {
    table.row({words, shape.words, shape.a, defined(distances).size(), median(distances), largest(distances)});
  };
  for (const Shape& shape : bernstein_shapes)
    row("Bernstein to the polygon", shape, of(found, bernstein(shape)).values(to_polygon));
  for (const Shape& shape : bernstein_shapes)
    row("trigonometric to the polygon", shape, of(found, trigonometric(shape)).values(to_polygon));
  for (const Shape& shape : bernstein_shapes)
    row("between the families", shape, found.rows().where({shape_key(shape.words)}).values(apart));
  return table;
}

/// Fig. 11: κ and Bernstein above, trigonometric below.
store::FigureRecord rows_figure(const Findings& found, const std::string& drawing) {
  store::FigureRecord figure{.id = "ekappa-bases-" + drawing,
                             .title = "Bernstein and trigonometric basis: " + drawing,
                             .caption =
                                 "Top: the κ-curve and cubic Bernstein curves; the first two are the same curve. "
                                 "Bottom: quadratic trigonometric curves. Curvature combs to one scale.",
                             .columns = 4};
  std::vector<std::string> labels = top_row();
  for (const Shape& shape : bottom_row) labels.push_back(trigonometric(shape));
  for (const std::string& label : labels)
    if (const auto cell = found.find(drawing, label)) figure.panels.push_back(Panel::curves({*cell}, label).comb());
  return figure;
}

/// Fig. 12: the drawing in both families, side by side.
store::FigureRecord pair_figure(const Findings& found, const std::string& drawing) {
  store::FigureRecord figure{.id = "ekappa-bases-" + drawing,
                             .title = "Both bases on a drawing: " + drawing,
                             .caption =
                                 "Cubic Bernstein basis and quadratic trigonometric basis. The paper does not print "
                                 "the a of its Fig. 12: with the same a the trigonometric curve is the sharper "
                                 "one, with a = 0.55 it is the rounder one.",
                             .columns = 3};
  const Shape& same = bernstein_shapes[1];
  for (const std::string& label : {bernstein(same), trigonometric(same), trigonometric(trigonometric_shapes[0])})
    if (const auto cell = found.find(drawing, label))
      figure.panels.push_back(Panel::curves({*cell}, label).without_joints());
  return figure;
}

store::FigureRecord numbers_figure() {
  return {.id = "ekappa-bases-numbers",
          .title = "Roundness of both families against a",
          .caption =
              "Medians over the curves of up to 100 points. Left: largest over mean |κ|. Right: distance from the "
              "polygon of the points, and between the two families at the same a, over the mean chord.",
          .columns = 2,
          .panels = {
              Panel::graph("families", "a as a number", {"peak over mean"}, "peak over mean |κ|")
                  .series("family")
                  .labels("a", ""),
              Panel::graph("distances", "a as a number", {"median"}, "distance").series("distance").labels("a", "")}};
}

void claim_rounder(Findings& found) {
  Tally peak, varies, polygon;
  std::vector<std::string> medians;
  for (const std::size_t k : {gentler + 1, gentler + 2}) {
    peak += less(found, peak_over_mean, k);
    varies += less(found, variation, k);
    polygon += others(less(found, to_polygon, k));
    medians.push_back(fmt::format("{:.3g} against {:.3g} at a = {}",
                                  of(found, trigonometric(trigonometric_shapes[k])).median(peak_over_mean),
                                  of(found, bernstein(counterpart(k))).median(peak_over_mean), counterpart(k).words));
  }
  found.judge(
      "trigonometric-rounder", peak,
      {fmt::format("smaller peak over mean |κ| on {} curves; medians {}", peak.words(), fmt::join(medians, ", ")),
       fmt::format("Curves of up to 100 points of all drawings at a = 0.75 and 0.9, same points and same a. Total "
                   "variation of κ is smaller on {}, and the curve is farther from the polygon on {}. What is "
                   "rounder is the trigonometric curve with a smaller a: against the κ-curve, its peak over mean "
                   "is smaller on {} curves at a = 0.55 and {} at 0.6.",
                   varies.words(), polygon.words(), less(found, peak_over_mean, 0).words(),
                   less(found, peak_over_mean, 1).words())});
}

/// The claim has two parts; it holds as far as the weaker one does.
void claim_approach(Findings& found) {
  Tally between, polygon;
  for (std::size_t k = 2; k < bernstein_shapes.size(); ++k) {
    const Shape &now = bernstein_shapes[k], &before = bernstein_shapes[k - 1];
    between += smaller(found, apart, shape_key(now.words), shape_key(before.words));
    polygon += smaller(found, to_polygon, spline(bernstein(now)), spline(bernstein(before)));
    polygon += smaller(found, to_polygon, spline(trigonometric(now)), spline(trigonometric(before)));
  }
  const Shape from = bernstein_shapes[1], to = bernstein_shapes.back();
  const auto medians = [&found, from, to](const Quantity& what, const KeyIs& at_from, const KeyIs& at_to) {
    return fmt::format("{:.3g} at a = {} and {:.3g} at {}", found.rows().where({at_from}).median(what), from.words,
                       found.rows().where({at_to}).median(what), to.words);
  };
  found.judge(
      "bases-approach", weaker(between, polygon),
      {fmt::format("median distance between the families {}; to the polygon {} (Bernstein), {} (trigonometric)",
                   medians(apart, shape_key(from.words), shape_key(to.words)),
                   medians(to_polygon, spline(bernstein(from)), spline(bernstein(to))),
                   medians(to_polygon, spline(trigonometric(from)), spline(trigonometric(to)))),
       fmt::format("Steps 0.75 to 0.9 to 0.99 on every curve of up to 100 points of all drawings, distances over "
                   "the mean chord: the distance between the families shrinks in {} steps, that to the polygon "
                   "in {}. The verdict is that of the weaker part.",
                   between.words(), polygon.words())});
}

void conclude(Findings& found) {
  for (const Table& table : {family_table(found), comparison_table(found), distance_table(found)}) found.add(table);
  for (const std::string& drawing : found.drawn()) {
    const auto cell = found.find(drawing, kappa_label);
    const bool one_curve = cell && found.cell(*cell).curves.size() == 1;
    found.add(one_curve ? rows_figure(found, drawing) : pair_figure(found, drawing));
  }
  found.add(numbers_figure());
  claim_rounder(found);
  claim_approach(found);
}

}  // namespace

Experiment ekappa_bases_experiment() {
  return study::experiment({.id = "ekappa-bases",
                            .title = "Bernstein and trigonometric basis (Miura 2022, Figs. 11 and 12)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"trigonometric-rounder", "bases-approach"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
