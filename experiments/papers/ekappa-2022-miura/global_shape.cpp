// Miura 2022, Figs. 3, 8 and 9: what one a for all points does to the curvature at the points and between them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/correspondence.hpp"
#include "metrics/curvature_profile.hpp"
#include "schemes/kappa/marks.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::count_of, study::Findings, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table,
    study::Tally;

constexpr std::string_view about =
    "One a for all points, from the κ-curve (a = 2/3) up to 0.95, on drawings of many curves. Measured over all "
    "drawings: that the points are interpolated, that a = 2/3 is the κ-curve, how many maxima of the magnitude of "
    "curvature a segment has, and whether a larger a raises the curvature at the points and lowers it between them.";

constexpr std::string_view face = "face";
/// The face in that drawing (datasets/points/face.txt): eyes, nose and mouth.
const std::vector<double> face_window{24.0, 76.0, 10.0, 62.0};

/// |kappa| times the mean chord from which a point is nearly a cusp: a radius of a tenth of the chord.
constexpr double nearly_cusped = 10.0;

// ---- what is measured

/// A row a fit; and for those with a curve the distance of its worst point, over the mean chord.
const Quantity solved = count_of("solved"), input_points = count_of("points of the input");
const Quantity interpolation{"interpolation error", "1", Method::exact};
/// A row a curve: the kappa-curve against a = 2/3.
const Quantity from_kappa{"distance from the kappa-curve", "1", Method::sampled};
const Quantity solved_by_one = count_of("solved by one only");
/// A row a segment, and a row a point with a segment of its own.
const Quantity more_maxima = count_of("more than one maximum"), not_certified = count_of("not certified");
const Quantity at_maximum = count_of("at a maximum"), pinned = count_of("pinned");
/// Where segments correspond at all a, a row a point and a row a joint: |kappa| times the mean chord.
const Quantity at_point{"curvature at point", "1", Method::exact}, at_joint{"curvature at joint", "1", Method::exact};
const Quantity pinned_there = count_of("pinned there");

bool is_peak(const ProfilePoint& point, const TurningPoint& turn) {
  return turn.maximum == (point.curvature > 0.0) && point.curvature != 0.0;
}

/// Maxima of |kappa| inside each segment, and whether its point is one of them.
void measure_segments(const Fit& fit, const Shape& shape, Notes& notes) {
  const Curve& curve = *fit.curve;
  const CurvatureProfile profile = curvature_profile(curve, rounding_of(fit.input));
  const std::vector<Node> nodes = inner_nodes(fit);
  const double chord = mean_chord(fit.input);
  for (int k = 0; k < curve.size(); ++k) {
    const auto points = profile.of_segment(k);
    std::vector<Vec2> peaks;
    for (const TurningPoint& turn : turning_points(points, profile.unit))
      if (is_peak(points[turn.index], turn))
        peaks.push_back(curve.segment(k).jet(points[turn.index].place.t, 0).position());
    notes.row({shape_key(shape.words)}, {more_maxima(peaks.size() > 1 ? 1 : 0),
                                         not_certified(profile.certification == Certification::exact ? 0 : 1)});
    const auto node = std::ranges::find(nodes, k, &Node::segment);
    if (node == nodes.end()) continue;
    const Vec2 here = curve.segment(k).jet(node->t, 0).position();
    const bool peaks_here =
        std::ranges::any_of(peaks, [&](const Vec2& p) { return (p - here).norm() <= 1e-6 * chord; });
    notes.row({shape_key(shape.words)},
              {at_maximum(peaks_here ? 1 : 0), pinned(node->has(kappa::marks::pinned) ? 1 : 0)});
  }
}

/// Largest distance of a point from where the curve should pass it; infinite for a point without a place.
double interpolation_error(const Fit& fit) {
  const Input& input = fit.input;
  double worst = 0.0;
  for (int i = 0; i < input.size(); ++i) {
    const Vec2& point = input.points[static_cast<std::size_t>(i)];
    double nearest = std::numeric_limits<double>::infinity();
    for (const Node& node : fit.curve->nodes())
      if (node.point == i)
        nearest = std::min(nearest, (fit.curve->segment(node.segment).jet(node.t, 0).position() - point).norm());
    if (!input.closed && i == 0) nearest = (fit.curve->start() - point).norm();
    if (!input.closed && i + 1 == input.size()) nearest = (fit.curve->end() - point).norm();
    worst = std::max(worst, nearest);
  }
  return worst / mean_chord(input);
}

/// |kappa| at the points and at the joints, for shapes whose segments correspond.
void measure_curvatures(const Fit& fit, const Shape& shape, int number, Notes& notes) {
  const Curve& curve = *fit.curve;
  const double chord = mean_chord(fit.input);
  for (const Node& node : inner_nodes(fit))
    notes.row({curve_key(number), point_key(node.point), shape_key(shape.words)},
              {at_point(chord * curvature_at(curve, node)), pinned_there(node.has(kappa::marks::pinned) ? 1 : 0)});
  for (const Joint& joint : curve.joints())
    notes.row({curve_key(number), joint_key(joint.segment), shape_key(shape.words)},
              {at_joint(chord * std::abs(curvature(curve.segment(joint.segment).jet(1.0, 2))))});
}

/// The schemes: figure_shapes, then the kappa-curve.
void measure_curve(const Uses& uses, const Input& input, int number, Notes& notes) {
  std::vector<Fit> fits;
  for (std::size_t k = 0; k < figure_shapes.size(); ++k) {
    fits.push_back(uses.schemes[k]->fit(input));
    notes.put(solved(study::solved(fits.back()) ? 1 : 0));
    if (!study::solved(fits.back())) continue;
    notes.row({}, {interpolation(interpolation_error(fits.back())), input_points(input.size())});
    measure_segments(fits.back(), figure_shapes[k], notes);
  }
  const Fit kappa = uses.schemes[figure_shapes.size()]->fit(input);
  const bool first = study::solved(fits.front());
  notes.put(solved_by_one(study::solved(kappa) != first ? 1 : 0));
  if (study::solved(kappa) && first)
    notes.put(from_kappa(deviation(spans(*kappa.curve), spans(*fits.front().curve), input.closed) / mean_chord(input)));
  const bool match = std::ranges::all_of(
      fits, [&](const Fit& fit) { return study::solved(fit) && fit.curve->size() == fits.front().curve->size(); });
  for (std::size_t k = 0; match && k < fits.size(); ++k) measure_curvatures(fits[k], figure_shapes[k], number, notes);
}

void measure(const Uses& uses, Notes& notes) {
  for (int number = 0; const Input& input : uses.drawings.front().curves) measure_curve(uses, input, number++, notes);
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : study::drawings_or(context, {face, "bear", "elephant"}))
    add_shape_jobs(jobs, context, drawing);
  std::vector<SchemePtr> schemes = figure_schemes(context.registry);
  schemes.push_back(context.registry.create("kappa"));
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(
        study::numbers_job<measure>({.work = "global shape",
                                     .schemes = schemes,
                                     .drawings = {drawing},
                                     .metrics = {&find_metric("monotone_intervals"), &find_metric("locality")}}));
  return jobs;
}

// ---- what follows

/// What there was at the a before figure_shapes[k], and what there is at it.
std::vector<study::Pair> steps(const Findings& found, const Quantity& what, std::size_t k) {
  return found.rows().pairs(what, shape_key(figure_shapes[k - 1].words), shape_key(figure_shapes[k].words));
}

/// Points or joints where |kappa| grows from the a before to the k-th.
Tally grows(const Findings& found, const Quantity& where, std::size_t k) {
  Tally tally;
  for (const auto& [before, now] : steps(found, where, k)) tally.add(now > before);
  return tally;
}

Table maxima_table(const Findings& found) {
  Table table("maxima", "Maxima of |κ| in segments and at points",
              "All drawings. Maxima are isolated exactly; a point counts as at a maximum when one inside its "
              "segment is within 1e-6 of the mean chord. Pinned points are at an end of their segment.");
  table.words("a").counts("segments").counts("with more than one maximum").counts("not certified");
  table.counts("points").counts("at a maximum").counts("pinned");
  for (const Shape& shape : figure_shapes) {
    const Rows rows = found.rows().where({shape_key(shape.words)});
    table.row({shape.words, rows.values(more_maxima).size(), rows.total(more_maxima), rows.total(not_certified),
               rows.values(at_maximum).size(), rows.total(at_maximum), rows.total(pinned)});
  }
  return table;
}

Table growth_table(const Findings& found) {
  Table table("growth", "Curvature at points and joints from one a to the next",
              "All drawings whose curves have corresponding segments at all four a; medians of |κ| times the "
              "mean chord at the larger a of the step.");
  table.words("step").counts("points").counts("larger |κ| at the point").numbers("median |κ| at points");
  table.counts("joints").counts("smaller |κ| at the joint").numbers("median |κ| at joints");
  for (std::size_t k = 0; k < figure_shapes.size(); ++k) {
    constexpr Tally no_step{undefined, undefined};
    const std::string_view words = figure_shapes[k].words;
    const Tally points = k == 0 ? no_step : grows(found, at_point, k);
    const Tally joints = k == 0 ? no_step : grows(found, at_joint, k);
    const Rows here = found.rows().where({shape_key(words)});
    table.row({k == 0 ? std::string(words) : fmt::format("{} to {}", figure_shapes[k - 1].words, words), points.cases,
               points.agree, here.median(at_point), joints.cases, joints.misses(), here.median(at_joint)});
  }
  return table;
}

/// Figs. 8 and 9: a row of growing a. Fig. 3: the same, and close-ups of the face below.
store::FigureRecord row_figure(const Findings& found, const std::string& drawing) {
  store::FigureRecord figure{.id = "ekappa-global-shape-" + drawing,
                             .title = "Global shape parameter: " + drawing,
                             .caption = "From the κ-curve to a = 0.95 at all points.",
                             .columns = static_cast<int>(figure_shapes.size())};
  std::vector<store::PanelRecord> close_ups;
  for (const Shape& shape : figure_shapes) {
    const auto cell = found.find(drawing, label_of_shape(shape));
    if (!cell) continue;
    figure.panels.push_back(Panel::curves({*cell}, label_of_shape(shape)).without_joints().without_points());
    close_ups.push_back(
        Panel::curves({*cell}, "close-up, " + label_of_shape(shape)).without_joints().window(face_window));
  }
  if (drawing == face) {
    figure.caption += " Bottom: the face (the frame above), with the input points.";
    std::ranges::move(close_ups, std::back_inserter(figure.panels));
  }
  return figure;
}

bool beyond_rounding(double distance) { return !(distance <= 1e-9); }

void claim_interpolation(Findings& found) {
  const std::vector<double> errors = found.rows().values(interpolation);
  const Tally missed = study::tally_of(errors, beyond_rounding);
  found.judge(
      "interpolates-points", study::all_but(missed.agree, missed.cases),
      {fmt::format("largest distance {:.2g} of the mean chord", largest(errors)),
       fmt::format("{:.0f} solved curves (of {}) of all drawings at a = 2/3, 0.75, 0.85 and 0.95 with {:.0f} "
                   "points in all; {:.0f} curves miss a point by more than 1e-9 of the mean chord.",
                   missed.cases, found.rows().values(solved).size(), found.rows().total(input_points), missed.agree)});
}

void claim_identity(Findings& found) {
  const std::vector<double> deviations = found.rows().values(from_kappa);
  const Tally apart = study::tally_of(deviations, beyond_rounding);
  const double by_one = found.rows().total(solved_by_one);
  found.judge(
      "quadratic-at-two-thirds", study::all_but(apart.agree + by_one, apart.cases + by_one),
      {fmt::format("largest deviation {:.2g} of the mean chord", largest(deviations)),
       fmt::format("`kappa` (quadratic segments) against `ekappa` with a = 2/3 (cubic segments) on {:.0f} curves "
                   "of all drawings that both solve; {:.0f} differ by more than 1e-9, {:.0f} are solved by one "
                   "only. Both use the same solver, so this tests the segments and the equation for t.",
                   apart.cases, apart.agree, by_one)});
}

void claim_maxima(Findings& found) {
  const Tally more = study::tally_of(found.rows().values(more_maxima));
  found.judge("one-maximum-per-segment", study::all_but(more.agree, more.cases),
              {fmt::format("{:.0f} of {:.0f} segments have more than one", more.agree, more.cases),
               fmt::format("Extrema of κ isolated exactly in every segment of all drawings at a = 2/3, 0.75, 0.85 and "
                           "0.95; {:.0f} segments could not be certified. This is a test on {:.0f} segments, not a "
                           "proof.",
                           found.rows().total(not_certified), more.cases)});
}

void claim_growth(Findings& found) {
  Tally sharper, flatter;
  double was_pinned = 0.0, was_cusped = 0.0;  // of the points that do not gain
  for (std::size_t k = 1; k < figure_shapes.size(); ++k) {
    const auto points = steps(found, at_point, k), pins = steps(found, pinned_there, k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [before, now] = points[i];
      sharper.add(now > before);
      if (now > before) continue;
      was_pinned += pins[i].first;
      was_cusped += before > nearly_cusped ? 1.0 : 0.0;
    }
    const Tally joints = grows(found, at_joint, k);
    flatter += {joints.misses(), joints.cases};
  }
  const Rows first = found.rows().where({shape_key(figure_shapes.front().words)});
  const Rows last = found.rows().where({shape_key(figure_shapes.back().words)});
  found.judge(
      "raising-a-sharpens-globally", weaker(sharper, flatter),
      {fmt::format("|κ| grows at the points in {} steps and falls at the joints in {}", sharper.words(),
                   flatter.words()),
       fmt::format("All drawings, steps 2/3, 0.75, 0.85, 0.95; joints stand for what lies between the points. "
                   "Median |κ| times the mean chord at points {:.3g} at 2/3 and {:.3g} at 0.95, at joints {:.3g} "
                   "and {:.3g}. Of the {:.0f} steps in which a point does not gain, {:.0f} start with the point "
                   "pinned and {:.0f} with |κ| above {:g} over the mean chord, nearly a cusp. The verdict is "
                   "that of the weaker part.",
                   first.median(at_point), last.median(at_point), first.median(at_joint), last.median(at_joint),
                   sharper.misses(), was_pinned, was_cusped, nearly_cusped)});
}

void conclude(Findings& found) {
  found.add(maxima_table(found));
  found.add(growth_table(found));
  for (const std::string& drawing : found.drawn()) found.add(row_figure(found, drawing));
  claim_interpolation(found);
  claim_identity(found);
  claim_maxima(found);
  claim_growth(found);
}

}  // namespace

Experiment ekappa_global_shape_experiment() {
  return study::experiment({.id = "ekappa-global-shape",
                            .title = "One a for all points (Miura 2022, Figs. 3, 8 and 9)",
                            .about = std::string(about),
                            .paper = std::string(paper),
                            .claims = {"interpolates-points", "quadratic-at-two-thirds", "one-maximum-per-segment",
                                       "raising-a-sharpens-globally"},
                            .jobs = jobs,
                            .conclude = conclude});
}

}  // namespace kappabench
