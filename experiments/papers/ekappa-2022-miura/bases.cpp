#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/verdicts.hpp"
#include "metrics/correspondence.hpp"
#include "schemes/curve/jet.hpp"

namespace kappabench {

using namespace miura;
using namespace study;

namespace {

constexpr std::string_view about =
    "The same points by cubic Bernstein and by quadratic trigonometric segments. Miura et al. call the latter more "
    "rounded, and say that both approach the polygon of the points as a grows. Roundness is measured by the largest "
    "over the mean magnitude of curvature, by the total variation of curvature, and by the distance from the polygon.";

/// Bottom row of Fig. 11; the last two also in its top row.
constexpr std::array<Shape, 4> trigonometric_shapes{{{0.55, "0.55"}, {0.6, "0.6"}, {0.75, "0.75"}, {0.9, "0.9"}}};
constexpr std::array<Shape, 3> bernstein_shapes{{{2.0 / 3.0, "2/3"}, {0.75, "0.75"}, {0.9, "0.9"}}};
/// Where the families are measured: both at the shared values, the trigonometric one also at its gentler two.
constexpr std::array<Shape, 4> shared_shapes{{{2.0 / 3.0, "2/3"}, {0.75, "0.75"}, {0.9, "0.9"}, {0.99, "0.99"}}};
constexpr std::array<Shape, 2> gentle_shapes{{{0.55, "0.55"}, {0.6, "0.6"}}};
constexpr std::string_view bernstein = "Bernstein", trigonometric_family = "trigonometric";

/// The columns of Fig. 11 and the shared values: trigonometric, Bernstein.
constexpr std::array<std::pair<Shape, Shape>, 6> compared{{{gentle_shapes[0], shared_shapes[0]},
                                                           {gentle_shapes[1], shared_shapes[0]},
                                                           {shared_shapes[0], shared_shapes[0]},
                                                           {shared_shapes[1], shared_shapes[1]},
                                                           {shared_shapes[2], shared_shapes[2]},
                                                           {shared_shapes[3], shared_shapes[3]}}};

/// Curves of more points are left out: with a = 0.55 they can take many seconds, for one row among hundreds.
constexpr int most_points = 100;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kappa_label = "κ-curve";
std::string label(std::string_view family, std::string_view words) { return fmt::format("{}, a = {}", family, words); }

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
  double peak = 0.0, variation = 0.0, turning = 0.0, length = 0.0;
  for (const Node& node : curve.nodes()) peak = std::max(peak, curvature_at(curve, node));
  double before = curvature(curve.closed() ? samples.jets.back() : samples.jets.front());
  for (std::size_t i = 0; i < samples.jets.size(); ++i) {
    const Jet& jet = samples.jets[i];
    const double kappa = curvature(jet);
    peak = std::max(peak, std::abs(kappa));
    variation += std::abs(kappa - before);
    before = kappa;
    if (i % samples.t.size() == 0) continue;
    const Jet& last = samples.jets[i - 1];
    length += (jet.position() - last.position()).norm();
    turning += std::abs(std::atan2(cross(last.d[1], jet.d[1]), last.d[1].dot(jet.d[1])));
  }
  return {turning > 0.0 ? peak * length / turning : none, variation * length};
}

/// The columns "<family> <a> <what>" of one fit, NaN without a solution; returns its spans.
std::vector<Span> measure_fit(const Fit& fit, std::string_view family, const Shape& shape, store::CellRecord& cell) {
  const bool curve = solved(fit);
  const Roundness round = curve ? roundness(*fit.curve) : Roundness{none, none};
  std::vector<Span> parts = curve ? spans(*fit.curve) : std::vector<Span>{};
  const double polygon = curve ? distance_to_polygon(parts, fit.input) / mean_chord(fit.input) : none;
  const auto column = [&](std::string_view what) { return fmt::format("{} {} {}", family, shape.words, what); };
  put(cell, column("peak over mean"), round.peak_over_mean, Method::sampled);
  put(cell, column("variation"), round.variation, Method::sampled);
  put(cell, column("polygon"), polygon, Method::sampled);
  return parts;
}

void measure_curve(const Registry& registry, const Input& input, store::CellRecord& cell) {
  for (const Shape& shape : gentle_shapes)
    (void)measure_fit(trigonometric(registry, shape.a)->fit(input), trigonometric_family, shape, cell);
  for (const Shape& shape : shared_shapes) {
    const auto first = measure_fit(cubic(registry, shape.a)->fit(input), bernstein, shape, cell);
    const auto second = measure_fit(trigonometric(registry, shape.a)->fit(input), trigonometric_family, shape, cell);
    const bool both = !first.empty() && !second.empty();
    const double apart = both ? deviation(first, second, input.closed) / mean_chord(input) : none;
    put(cell, fmt::format("apart {}", shape.words), std::isfinite(apart) ? apart : none, Method::sampled);
  }
}

void add_drawn_jobs(std::vector<CellJob>& jobs, const Context& context, const Drawing& drawing) {
  jobs.push_back(drawn_job(drawing, context.registry.create("kappa"), std::string(kappa_label)));
  for (const Shape& shape : bernstein_shapes)
    jobs.push_back(drawn_job(drawing, cubic(context.registry, shape.a), label(bernstein, shape.words)));
  for (const Shape& shape : trigonometric_shapes)
    jobs.push_back(
        drawn_job(drawing, trigonometric(context.registry, shape.a), label(trigonometric_family, shape.words)));
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : drawings_or(context, {"five-drop", "christmas-tree"}))
    add_drawn_jobs(jobs, context, drawing);
  const Registry& registry = context.registry;
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(study_job(drawing, trigonometric(registry, 0.75), "bases", 1,
                             [&registry](const Drawing& points, store::CellRecord& cell) {
                               for (const Input& input : points.curves)
                                 if (input.size() <= most_points) measure_curve(registry, input, cell);
                             }));
  return jobs;
}

// ---- from the finished cells

std::vector<double> column(const store::ExperimentRecord& record, std::string_view family, const Shape& shape,
                           std::string_view what) {
  return values(record, fmt::format("{} {} {}", family, shape.words, what));
}

std::vector<double> apart(const store::ExperimentRecord& record, const Shape& shape) {
  return values(record, fmt::format("apart {}", shape.words));
}

/// Curves where the first number is smaller than the second, and curves that have both.
struct Count {
  double smaller = 0.0, cases = 0.0;
  Count& operator+=(const Count& other) {
    smaller += other.smaller, cases += other.cases;
    return *this;
  }
};

Count count_smaller(const std::vector<double>& a, const std::vector<double>& b) {
  Count count;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i])) continue;
    count.cases += 1.0;
    count.smaller += a[i] < b[i] ? 1.0 : 0.0;
  }
  return count;
}

/// Curves on which the trigonometric curve has less of it than the Bernstein one.
Count less(const store::ExperimentRecord& record, std::string_view what, const std::pair<Shape, Shape>& shapes) {
  return count_smaller(column(record, trigonometric_family, shapes.first, what),
                       column(record, bernstein, shapes.second, what));
}

store::TableRecord family_table(const store::ExperimentRecord& record) {
  TableBuilder builder("families", "Roundness of both families",
                       "Medians over the curves of up to 100 points of all drawings, as far as solved. Peak over mean "
                       "is the largest over the "
                       "mean |κ| along the curve (1 for a circle); variation is the total variation of κ times the "
                       "length; the distance is over the mean chord, largest along a curve.");
  builder.words("family").words("a").numbers("a as a number").counts("curves").numbers("peak over mean");
  builder.numbers("variation").numbers("distance to the polygon");
  const auto row = [&](std::string_view family, const Shape& shape) {
    const auto of = [&](std::string_view what) { return column(record, family, shape, what); };
    builder.row({std::string(family), std::string(shape.words), shape.a,
                 count_smaller(of("polygon"), of("polygon")).cases, median(of("peak over mean")),
                 median(of("variation")), median(of("polygon"))});
  };
  for (const Shape& shape : shared_shapes) row(bernstein, shape);
  for (const Shape& shape : gentle_shapes) row(trigonometric_family, shape);
  for (const Shape& shape : shared_shapes) row(trigonometric_family, shape);
  return builder.table();
}

store::TableRecord comparison_table(const store::ExperimentRecord& record) {
  TableBuilder builder("comparison", "Trigonometric against Bernstein",
                       "Counts of the curves on which the trigonometric one is rounder: a smaller number, or farther "
                       "from the polygon. The first two rows compare with the κ-curve, as Fig. 11 does.");
  builder.words("trigonometric a").words("Bernstein a").counts("curves").counts("smaller peak over mean");
  builder.counts("smaller variation").counts("farther from the polygon");
  for (const auto& shapes : compared) {
    const Count peak = less(record, "peak over mean", shapes), polygon = less(record, "polygon", shapes);
    builder.row({std::string(shapes.first.words), std::string(shapes.second.words), peak.cases, peak.smaller,
                 less(record, "variation", shapes).smaller, polygon.cases - polygon.smaller});
  }
  return builder.table();
}

store::TableRecord distance_table(const store::ExperimentRecord& record) {
  TableBuilder builder(
      "distances", "Distances as a grows",
      "Largest distance along a curve over the mean chord: from the polygon of the points, and between "
      "the families at the same a at equal parts of the arc length from point to point.");
  builder.words("distance").words("a").numbers("a as a number").counts("curves").numbers("median").numbers("largest");
  const auto row = [&](std::string words, const Shape& shape, const std::vector<double>& distances) {
    builder.row({std::move(words), std::string(shape.words), shape.a, count_smaller(distances, distances).cases,
                 median(distances), largest(distances)});
  };
  for (const std::string_view family : {bernstein, trigonometric_family})
    for (const Shape& shape : shared_shapes)
      row(fmt::format("{} to the polygon", family), shape, column(record, family, shape, "polygon"));
  for (const Shape& shape : shared_shapes) row("between the families", shape, apart(record, shape));
  return builder.table();
}

/// Fig. 11: κ and Bernstein above, trigonometric below.
std::optional<store::FigureRecord> rows_figure(const store::ExperimentRecord& record, const std::string& dataset) {
  store::FigureRecord figure{.id = "ekappa-bases-" + dataset,
                             .title = fmt::format("Bernstein and trigonometric basis: {}", dataset),
                             .caption =
                                 "Top: the κ-curve and cubic Bernstein curves; the first two are the same curve. "
                                 "Bottom: quadratic trigonometric curves. Curvature combs to one scale.",
                             .columns = 4,
                             .panels = {}};
  std::vector<std::string> labels{std::string(kappa_label)};
  for (const Shape& shape : bernstein_shapes) labels.push_back(label(bernstein, shape.words));
  for (const Shape& shape : trigonometric_shapes) labels.push_back(label(trigonometric_family, shape.words));
  for (const std::string& text : labels) {
    const auto index = drawn_cell(record, dataset, text);
    if (!index) return std::nullopt;
    store::PanelRecord panel{.kind = "curve", .title = text, .cells = {*index}};
    panel.comb = true;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

/// Fig. 12: the drawing in both families, side by side.
std::optional<store::FigureRecord> pair_figure(const store::ExperimentRecord& record, const std::string& dataset) {
  store::FigureRecord figure{.id = "ekappa-bases-" + dataset,
                             .title = fmt::format("Both bases on a drawing: {}", dataset),
                             .caption =
                                 "Cubic Bernstein basis and quadratic trigonometric basis. The paper does not print "
                                 "the a of its Fig. 12: with the same a the trigonometric curve is the sharper "
                                 "one, with a = 0.55 it is the rounder one.",
                             .columns = 3,
                             .panels = {}};
  for (const std::string& text :
       {label(bernstein, "0.75"), label(trigonometric_family, "0.75"), label(trigonometric_family, "0.55")}) {
    const auto index = drawn_cell(record, dataset, text);
    if (!index) return std::nullopt;
    store::PanelRecord panel{.kind = "curve", .title = text, .cells = {*index}};
    panel.joints = false;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

store::PanelRecord graph(std::string table, std::string y, std::string series, std::string title) {
  store::PanelRecord panel{.kind = "graph", .title = std::move(title)};
  panel.table = std::move(table);
  panel.x = "a as a number";
  panel.x_label = "a";
  panel.y = {std::move(y)};
  panel.series = std::move(series);
  return panel;
}

store::FigureRecord numbers_figure() {
  return {.id = "ekappa-bases-numbers",
          .title = "Roundness of both families against a",
          .caption =
              "Medians over the curves of up to 100 points. Left: largest over mean |κ|. Right: distance from the "
              "polygon of the points, and between the two families at the same a, over the mean chord.",
          .columns = 2,
          .panels = {graph("families", "peak over mean", "family", "peak over mean |κ|"),
                     graph("distances", "median", "distance", "distance")}};
}

store::ClaimRecord rounder_claim(const store::ExperimentRecord& record) {
  Count peak, variation, polygon;
  std::string medians;
  for (const std::size_t k : {1U, 2U}) {
    const Shape& shape = shared_shapes[k];
    peak += less(record, "peak over mean", {shape, shape});
    variation += less(record, "variation", {shape, shape});
    polygon += less(record, "polygon", {shape, shape});
    medians += fmt::format("{}{:.3g} against {:.3g} at a = {}", medians.empty() ? "" : ", ",
                           median(column(record, trigonometric_family, shape, "peak over mean")),
                           median(column(record, bernstein, shape, "peak over mean")), shape.words);
  }
  const Count gentlest = less(record, "peak over mean", compared[0]),
              gentle = less(record, "peak over mean", compared[1]);
  return claim(
      "trigonometric-rounder", verdict_in_general(peak.smaller, peak.cases),
      fmt::format("smaller peak over mean |κ| on {} curves; medians {}", share(peak.smaller, peak.cases), medians),
      fmt::format(
          "Curves of up to 100 points of all drawings at a = 0.75 and 0.9, same points and same a. Total variation of "
          "κ is smaller on "
          "{}, and the curve is farther from the polygon on {}. What is rounder is the trigonometric curve with a "
          "smaller a: against the κ-curve, its peak over mean is smaller on {} curves at a = 0.55 and {} at 0.6.",
          share(variation.smaller, variation.cases), share(polygon.cases - polygon.smaller, polygon.cases),
          share(gentlest.smaller, gentlest.cases), share(gentle.smaller, gentle.cases)));
}

/// The claim has two parts; it holds as far as the weaker one does.
store::ClaimRecord approach_claim(const store::ExperimentRecord& record) {
  Count between, polygon;
  for (std::size_t k = 2; k < shared_shapes.size(); ++k) {
    const Shape &now = shared_shapes[k], &before = shared_shapes[k - 1];
    between += count_smaller(apart(record, now), apart(record, before));
    for (const std::string_view family : {bernstein, trigonometric_family})
      polygon += count_smaller(column(record, family, now, "polygon"), column(record, family, before, "polygon"));
  }
  const bool weaker = between.smaller * polygon.cases < polygon.smaller * between.cases;
  const Count& decisive = weaker ? between : polygon;
  const Shape &from = shared_shapes[1], &to = shared_shapes.back();
  const auto medians = [&](const std::vector<double>& at_from, const std::vector<double>& at_to) {
    return fmt::format("{:.3g} at a = {} and {:.3g} at {}", median(at_from), from.words, median(at_to), to.words);
  };
  const auto to_polygon = [&](std::string_view family) {
    return medians(column(record, family, from, "polygon"), column(record, family, to, "polygon"));
  };
  return claim(
      "bases-approach", verdict_in_general(decisive.smaller, decisive.cases),
      fmt::format("median distance between the families {}; to the polygon {} (Bernstein), {} (trigonometric)",
                  medians(apart(record, from), apart(record, to)), to_polygon(bernstein),
                  to_polygon(trigonometric_family)),
      fmt::format("Steps 0.75 to 0.9 to 0.99 on every curve of up to 100 points of all drawings, distances over the "
                  "mean chord: the "
                  "distance between the families shrinks in {} steps, that to the polygon in {}. The verdict is "
                  "that of the weaker part.",
                  share(between.smaller, between.cases), share(polygon.smaller, polygon.cases)));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {family_table(record), comparison_table(record), distance_table(record)};
  for (const std::string& dataset : drawn_datasets(record)) {
    const auto& cells = record.cells;
    const auto cell = std::ranges::find(cells, dataset, &store::CellRecord::dataset);
    auto figure = cell->curves.size() == 1 ? rows_figure(record, dataset) : pair_figure(record, dataset);
    if (figure) record.figures.push_back(std::move(*figure));
  }
  record.figures.push_back(numbers_figure());
  record.claims = {rounder_claim(record), approach_claim(record)};
}

}  // namespace

Experiment ekappa_bases_experiment() {
  return {.id = "ekappa-bases",
          .title = "Bernstein and trigonometric basis (Miura 2022, Figs. 11 and 12)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
