#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/selection.hpp"
#include "experiments/study/study.hpp"
#include "experiments/study/summaries.hpp"
#include "experiments/study/verdicts.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {

using namespace ekappa;
using namespace study;

namespace {

constexpr std::string_view about =
    "Where the curve changes from a left to a right bend its segments meet with equal magnitudes of curvature but "
    "opposite signs. Miura et al. show that this jump shrinks as a grows. Drawn here on two curves with inflections, "
    "with close-ups; measured at every joint of every drawing.";

/// Fits at all shapes with segments that correspond one to one; empty if one of them is missing.
std::vector<Fit> matching_fits(const Registry& registry, const Input& input, store::CellRecord& cell) {
  std::vector<Fit> fits;
  for (const Shape& shape : figure_shapes) {
    Fit fit = cubic(registry, shape.a)->fit(input);
    put(cell, "fits", 1.0);
    if (!solved(fit)) {
      put(cell, "fits without a solution", 1.0);
      continue;
    }
    fits.push_back(std::move(fit));
  }
  const bool all = fits.size() == figure_shapes.size();
  const bool match =
      all && std::ranges::all_of(fits, [&](const Fit& fit) { return fit.curve->size() == fits.front().curve->size(); });
  return match ? fits : std::vector<Fit>{};
}

/// Joints by what they are, and whether they keep it.
void measure_joints(const Fit& fit, store::CellRecord& cell) {
  for (const JointJump& jump : joint_jumps(*fit.curve, mean_chord(fit.input))) {
    const bool inflection = jump.joint.claimed == Continuity::g1_equal_magnitude;
    put(cell, inflection ? "joints at inflections" : "joints elsewhere", 1.0);
    put(cell, inflection ? "angle at inflections" : "angle elsewhere", jump.angle);
    put(cell, inflection ? "magnitude jump at inflections" : "curvature jump elsewhere",
        inflection ? jump.curvature_magnitude : jump.curvature);
    if (!jump.meets_claim()) put(cell, "joints that miss their claim", 1.0);
  }
}

/// The larger |kappa| at the two points beside the joint after `segment`.
double peak_beside(const Fit& fit, int segment) {
  double largest = 0.0;
  for (const Node& node : inner_nodes(fit))
    if (node.segment == segment || node.segment == fit.curve->next(segment))
      largest = std::max(largest, curvature_at(*fit.curve, node));
  return largest;
}

void measure_inflections(const std::vector<Fit>& fits, store::CellRecord& cell) {
  const double chord = mean_chord(fits.front().input);
  for (std::size_t j = 0; j < fits.front().curve->joints().size(); ++j) {
    const auto is_inflection = [j](const Fit& fit) {
      return fit.curve->joints()[j].claimed == Continuity::g1_equal_magnitude;
    };
    if (!std::ranges::any_of(fits, is_inflection)) continue;
    if (!std::ranges::all_of(fits, is_inflection)) {
      put(cell, "inflections at some a only", 1.0);
      continue;
    }
    for (std::size_t k = 0; k < fits.size(); ++k) {
      const Curve& curve = *fits[k].curve;
      const int segment = curve.joints()[j].segment;
      const double before = curvature(curve.segment(segment).jet(1.0, 2));
      const double after = curvature(curve.segment(curve.next(segment)).jet(0.0, 2));
      const double peak = peak_beside(fits[k], segment);
      put(cell, fmt::format("curvature {}", figure_shapes[k].words),
          chord * std::max(std::abs(before), std::abs(after)));
      put(cell, fmt::format("gap {}", figure_shapes[k].words), chord * std::abs(after - before));
      put(cell, fmt::format("gap over peak {}", figure_shapes[k].words), std::abs(after - before) / peak);
    }
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : drawings_or(context, {"s-inflections", "closed-inflections"}))
    add_shape_jobs(jobs, context, drawing);
  const Registry& registry = context.registry;
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(study_job(drawing, cubic(registry, figure_shapes[0].a), "joints", 1,
                             [&registry](const Drawing& points, store::CellRecord& cell) {
                               for (const Input& input : points.curves) {
                                 const std::vector<Fit> fits = matching_fits(registry, input, cell);
                                 for (const Fit& fit : fits) measure_joints(fit, cell);
                                 if (!fits.empty()) measure_inflections(fits, cell);
                               }
                             }));
  return jobs;
}

/// How many of the joints have less at the k-th shape than at the one before.
double falls(const store::ExperimentRecord& record, const std::string& what, std::size_t k) {
  const auto now = values(record, fmt::format("{} {}", what, figure_shapes[k].words));
  const auto before = values(record, fmt::format("{} {}", what, figure_shapes[k - 1].words));
  double count = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) count += now[i] < before[i] ? 1.0 : 0.0;
  return count;
}

std::vector<double> ratios(const store::ExperimentRecord& record, std::string_view dataset, std::size_t k) {
  const auto now = values(record, fmt::format("curvature {}", figure_shapes[k].words), dataset);
  const auto first = values(record, fmt::format("curvature {}", figure_shapes[0].words), dataset);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < now.size(); ++i) ratios.push_back(now[i] / first[i]);
  return ratios;
}

constexpr std::string_view all_words = "all drawings";

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("inflections", "Curvature at inflection joints",
                       "Over the joints that are inflections at all four a. Curvature and jump times the mean chord of "
                       "the points; the peak is the larger |κ| at the two points beside the joint. The factor of Eq. "
                       "(8) is (1 - a) / a² over its value at 2/3: what a alone does, with legs and areas unchanged.");
  builder.words("drawing").words("a").numbers("a as a number").counts("joints");
  builder.numbers("median |κ|").numbers("median jump").numbers("median jump over peak");
  builder.numbers("median ratio to 2/3").numbers("largest ratio to 2/3").numbers("factor of Eq. (8)");
  std::vector<std::string> groups = drawn_datasets(record);
  groups.emplace_back(all_words);
  for (const std::string& group : groups) {
    const std::string_view dataset = group == all_words ? std::string_view() : std::string_view(group);
    for (std::size_t k = 0; k < figure_shapes.size(); ++k) {
      const auto& [a, words] = figure_shapes[k];
      const auto of = [&](std::string_view what) { return values(record, fmt::format("{} {}", what, words), dataset); };
      builder.row({group, std::string(words), a, static_cast<double>(of("curvature").size()), median(of("curvature")),
                   median(of("gap")), median(of("gap over peak")), median(ratios(record, dataset, k)),
                   largest(ratios(record, dataset, k)), (1.0 - a) / (a * a) * 4.0 / 3.0});
    }
  }
  return builder.table();
}

store::TableRecord steps_table(const store::ExperimentRecord& record) {
  TableBuilder builder("steps", "Joints where the jump shrinks from one a to the next",
                       "Over all drawings; joints that are inflections at all four a.");
  builder.words("step").counts("joints").counts("smaller |κ|").counts("smaller jump");
  for (std::size_t k = 1; k < figure_shapes.size(); ++k)
    builder.row({fmt::format("{} to {}", figure_shapes[k - 1].words, figure_shapes[k].words),
                 static_cast<double>(values(record, "curvature 2/3").size()), falls(record, "curvature", k),
                 falls(record, "gap", k)});
  return builder.table();
}

store::TableRecord continuity_table(const store::ExperimentRecord& record) {
  TableBuilder builder("continuity", "What joints keep",
                       "All drawings at all four a. Jumps of curvature relative to the larger side (or to one over the "
                       "length of the curve, if that is more); angles in radians. At inflections the jump of |κ|.");
  builder.words("joints").counts("number").numbers("largest angle", "rad").numbers("largest jump");
  builder.row({std::string("at inflections"), total(record, "joints at inflections"),
               largest(values(record, "angle at inflections")),
               largest(values(record, "magnitude jump at inflections"))});
  builder.row({std::string("elsewhere"), total(record, "joints elsewhere"), largest(values(record, "angle elsewhere")),
               largest(values(record, "curvature jump elsewhere"))});
  return builder.table();
}

/// |kappa| at the end of the segment before a joint.
double curvature_at_joint(const store::CurveRecord& curve, std::size_t joint) {
  const auto samples = static_cast<std::size_t>(curve.samples_per_segment);
  return std::abs(curve.sample_kappa[(static_cast<std::size_t>(curve.joint_segment[joint]) + 1) * samples - 1]);
}

/// The inflection with the largest jump.
std::optional<std::size_t> joint_to_show(const store::CurveRecord& curve) {
  std::optional<std::size_t> best;
  for (std::size_t j = 0; j < curve.joint_segment.size(); ++j)
    if (curve.joint_claimed[j] == name(Continuity::g1_equal_magnitude) &&
        (!best || curvature_at_joint(curve, j) > curvature_at_joint(curve, *best)))
      best = j;
  return best;
}

/// The joint of `curve` nearest to a place.
std::pair<double, double> nearest_joint(const store::CurveRecord& curve, std::pair<double, double> place) {
  std::pair<double, double> best = place;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < curve.joint_x.size(); ++j) {
    const double d = std::hypot(curve.joint_x[j] - place.first, curve.joint_y[j] - place.second);
    if (d < distance) distance = d, best = {curve.joint_x[j], curve.joint_y[j]};
  }
  return best;
}

/// Fig. 7: the four curves with combs, and below each the close-up at an inflection.
std::optional<store::FigureRecord> curves_figure(const store::ExperimentRecord& record, const std::string& dataset) {
  store::FigureRecord figure{.id = "ekappa-inflection-" + dataset,
                             .title = fmt::format("Curvature at inflections: {}", dataset),
                             .caption = {},
                             .columns = static_cast<int>(figure_shapes.size())};
  figure.caption =
      "Top: the κ-curve and εκ-curves with their curvature combs, to one scale. Bottom: close-ups at the inflection "
      "with the largest jump (the frame above), combs six times as long. The comb changes sides at the joint; the step "
      "is the G2 error, and shrinks as a grows.";
  std::vector<store::PanelRecord> close_ups;
  std::optional<std::pair<double, double>> place;
  for (const Shape& shape : figure_shapes) {
    const auto index = drawn_cell(record, dataset, label_of_shape(shape));
    if (!index) return std::nullopt;
    const store::CellRecord& cell = record.cells[static_cast<std::size_t>(*index)];
    store::PanelRecord panel{.kind = "curve", .title = cell.label, .cells = {*index}};
    panel.comb = true;
    panel.comb_scale = 0.2;
    figure.panels.push_back(panel);
    if (cell.curves.empty() || cell.curves.front().sample_x.empty()) continue;
    const store::CurveRecord& curve = cell.curves.front();
    if (const auto joint = joint_to_show(curve); joint && !place)
      place = std::pair(curve.joint_x[*joint], curve.joint_y[*joint]);
    if (!place) continue;
    const auto [x, y] = nearest_joint(curve, *place);
    panel.title = "close-up, " + cell.label;
    panel.window = window_at(curve, x, y, 0.16);
    panel.comb_scale *= 6.0;
    close_ups.push_back(std::move(panel));
  }
  std::ranges::move(close_ups, std::back_inserter(figure.panels));
  return figure;
}

/// Curvature along the first drawing, a stretch around the inflection with the largest jump.
std::optional<store::PanelRecord> curvature_panel(const store::ExperimentRecord& record) {
  const auto datasets = drawn_datasets(record);
  if (datasets.empty()) return std::nullopt;
  store::PanelRecord panel{.kind = "curvature", .title = datasets.front() + ", at the inflection", .cells = {}};
  for (const Shape& shape : figure_shapes)
    if (const auto index = drawn_cell(record, datasets.front(), label_of_shape(shape))) panel.cells.push_back(*index);
  if (panel.cells.empty()) return std::nullopt;
  panel.curve = 0;
  const store::CellRecord& first = record.cells[static_cast<std::size_t>(panel.cells.front())];
  if (first.curves.empty()) return std::nullopt;
  const store::CurveRecord& curve = first.curves.front();
  if (const auto joint = joint_to_show(curve)) {
    const double s = curve.joint_s[*joint] / curve.sample_s.back(), kappa = 4.0 * curvature_at_joint(curve, *joint);
    panel.window = {s - 0.18, s + 0.18, -kappa, kappa};
  }
  return panel;
}

store::FigureRecord numbers_figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{.id = "ekappa-inflection-numbers",
                             .title = "Jump of curvature at inflections against a",
                             .caption =
                                 "Left: curvature along the curve around an inflection; the jump is the gap "
                                 "between the two ends at the joint. Right: the median jump at inflection "
                                 "joints, against a.",
                             .columns = 2,
                             .panels = {}};
  if (auto panel = curvature_panel(record)) figure.panels.push_back(std::move(*panel));
  store::PanelRecord graph{.kind = "graph", .title = "jump at inflections"};
  graph.table = "inflections";
  graph.x = "a as a number";
  graph.y = {"median jump"};
  graph.series = "drawing";
  graph.log_y = true;
  graph.x_label = "a";
  graph.y_label = "median jump × mean chord";
  figure.panels.push_back(std::move(graph));
  return figure;
}

/// A claim about |kappa| or its jump at inflections: what generally happens, exceptions counted.
store::ClaimRecord shrinking_claim(const store::ExperimentRecord& record, std::string_view id,
                                   const std::string& what) {
  const auto joints = static_cast<double>(values(record, what + " 2/3").size());
  double agree = 0.0;
  std::string medians;
  for (std::size_t k = 1; k < figure_shapes.size(); ++k) {
    agree += falls(record, what, k);
    medians += fmt::format("{}{:.3g} at {}", k == 1 ? "" : ", ", median(ratios(record, {}, k)), figure_shapes[k].words);
  }
  const double steps = joints * static_cast<double>(figure_shapes.size() - 1);
  return claim(id, verdict_in_general(agree, steps),
               fmt::format("smaller in {} steps; median ratio to a = 2/3: {}", share(agree, steps), medians),
               fmt::format("{:.0f} joints of all drawings that are inflections at a = 2/3, 0.75, 0.85 and 0.95, three "
                           "steps each; in {:.0f} steps it grows. {:.0f} joints are inflections at some a only and "
                           "left out. The magnitudes agree on both sides, so the jump is twice |κ|.",
                           joints, steps - agree, total(record, "inflections at some a only")));
}

/// "; the misses are in a, b", or nothing.
std::string where_missed(const store::ExperimentRecord& record) {
  std::vector<std::string> where;
  for (const store::CellRecord& cell : record.cells)
    if (measured(cell, "joints that miss their claim")) where.push_back(cell.dataset);
  return where.empty() ? "" : fmt::format("; the misses are in {}", fmt::join(where, ", "));
}

store::ClaimRecord continuity_claim(const store::ExperimentRecord& record) {
  const double inflections = total(record, "joints at inflections"), others = total(record, "joints elsewhere");
  const double misses = total(record, "joints that miss their claim");
  return claim("g2-except-inflections", verdict_in_general(inflections + others - misses, inflections + others),
               fmt::format("{} joints", share(inflections + others - misses, inflections + others)),
               fmt::format("{:.0f} joints elsewhere: largest relative jump of curvature {:.2g}, largest angle {:.2g} "
                           "rad; {:.0f} joints at inflections: largest angle {:.2g} rad, |κ| agrees to {:.2g} but has "
                           "opposite signs. A miss is an angle above 1e-7 rad or a relative jump above 1e-6, rounding "
                           "of the control points allowed for{}. {:.0f} of {:.0f} fits are left out: no solution found "
                           "or input that a scheme cannot take.",
                           others, largest(values(record, "curvature jump elsewhere")),
                           largest(values(record, "angle elsewhere")), inflections,
                           largest(values(record, "angle at inflections")),
                           largest(values(record, "magnitude jump at inflections")), where_missed(record),
                           total(record, "fits without a solution"), total(record, "fits")));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {table(record), steps_table(record), continuity_table(record)};
  for (const std::string& dataset : drawn_datasets(record))
    if (auto figure = curves_figure(record, dataset)) record.figures.push_back(std::move(*figure));
  record.figures.push_back(numbers_figure(record));
  record.claims = {continuity_claim(record), shrinking_claim(record, "inflection-curvature-shrinks", "curvature"),
                   shrinking_claim(record, "inflection-gap-shrinks", "gap")};
}

}  // namespace

Experiment ekappa_inflection_experiment() {
  return {.id = "ekappa-inflection",
          .title = "Curvature at inflections as a grows (Miura 2022, Fig. 7)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
