// Miura 2022, Fig. 7: how curvature jumps at inflections, and that the jump shrinks as a grows.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "experiments/papers/ekappa-2022-miura/common.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/continuity.hpp"

namespace kappabench {
namespace {

using namespace miura;
using study::count_of;
using study::Findings, study::Key, study::Notes, study::Panel, study::Quantity, study::Rows, study::Table, study::Tally;

constexpr std::string_view about =
    "Where the curve changes from a left to a right bend its segments meet with equal magnitudes of curvature but "
    "opposite signs. Miura et al. show that this jump shrinks as a grows. Drawn here on two curves with inflections, "
    "with close-ups; measured at every joint of every drawing.";

// ---- what is measured

const Key kind{"joint is"};
constexpr std::string_view at_inflection = "at an inflection", elsewhere = "elsewhere";

const Quantity unsolved = count_of("fit without a solution"), at_some_a_only = count_of("inflection at some a only");
/// At every joint: the angle of the tangents; the jump of |kappa| at an inflection, of kappa elsewhere.
const Quantity angle{"angle", "rad", Method::exact}, jump{"relative jump", "1", Method::exact};
const Quantity missed = count_of("claim missed");
/// At inflections, for each a: |kappa| and the jump, times the mean chord; the jump over the peak beside it.
const Quantity magnitude{"curvature", "1", Method::exact}, gap{"gap", "1", Method::exact};
const Quantity gap_over_peak{"gap over peak", "1", Method::exact};

bool is_inflection(const Joint& joint) { return joint.claimed == Continuity::g1_equal_magnitude; }

/// Fits at all shapes with segments that correspond one to one; empty if one of them is missing.
std::vector<Fit> matching_fits(const Uses& uses, const Input& input, Notes& notes) {
  std::vector<Fit> fits;
  for (const SchemePtr& scheme : uses.schemes) {
    Fit fit = scheme->fit(input);
    notes.put(unsolved(study::solved(fit) ? 0 : 1));
    if (study::solved(fit)) fits.push_back(std::move(fit));
  }
  const bool match = fits.size() == uses.schemes.size() && std::ranges::all_of(fits, [&](const Fit& fit) {
                       return fit.curve->size() == fits.front().curve->size();
                     });
  return match ? fits : std::vector<Fit>{};
}

/// Joints by what they are, and whether they keep it.
void measure_joints(const Fit& fit, Notes& notes) {
  for (const JointJump& found : joint_jumps(*fit.curve, fit.input)) {
    const bool inflection = is_inflection(found.joint);
    notes.row({kind(inflection ? at_inflection : elsewhere)},
              {angle(found.angle), jump(inflection ? found.curvature_magnitude : found.curvature),
               missed(found.meets_claim ? 0 : 1)});
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

/// Joints that are inflections at every a; those at some a only are counted.
void measure_inflections(const std::vector<Fit>& fits, int curve_number, Notes& notes) {
  const double chord = mean_chord(fits.front().input);
  for (std::size_t j = 0; j < fits.front().curve->joints().size(); ++j) {
    const auto there =
        std::ranges::count_if(fits, [j](const Fit& fit) { return is_inflection(fit.curve->joints()[j]); });
    if (there > 0 && there < std::ssize(fits)) notes.put(at_some_a_only(1));
    for (std::size_t k = 0; there == std::ssize(fits) && k < fits.size(); ++k) {
      const Curve& curve = *fits[k].curve;
      const int segment = curve.joints()[j].segment;
      const double before = curvature(curve.segment(segment).jet(1.0, 2));
      const double after = curvature(curve.segment(curve.next(segment)).jet(0.0, 2));
      notes.row({curve_key(curve_number), joint_key(j), shape_key(figure_shapes[k].words)},
                {magnitude(chord * std::max(std::abs(before), std::abs(after))), gap(chord * std::abs(after - before)),
                 gap_over_peak(std::abs(after - before) / peak_beside(fits[k], segment))});
    }
  }
}

void measure(const Uses& uses, Notes& notes) {
  int number = 0;
  for (const Input& input : uses.drawings.front().curves) {
    const std::vector<Fit> fits = matching_fits(uses, input, notes);
    for (const Fit& fit : fits) measure_joints(fit, notes);
    if (!fits.empty()) measure_inflections(fits, number, notes);
    ++number;
  }
}

std::vector<CellJob> jobs(const Context& context) {
  std::vector<CellJob> jobs;
  for (const Drawing& drawing : study::drawings_or(context, {"s-inflections", "closed-inflections"}))
    add_shape_jobs(jobs, context, drawing);
  for (const Drawing& drawing : study::drawings_of(context))
    jobs.push_back(study::numbers_job<measure>({.work = "curvature at joints",
                                                .schemes = figure_schemes(context.registry),
                                                .drawings = {drawing},
                                                .metrics = {&find_metric("continuity")}}));
  return jobs;
}

// ---- what follows

/// Over corresponding joints, from the a before figure_shapes[k]: how often is it less?
Tally falls(const Rows& rows, const Quantity& what, std::size_t k) {
  Tally tally;
  for (const auto& [before, now] :
       rows.pairs(what, shape_key(figure_shapes[k - 1].words), shape_key(figure_shapes[k].words)))
    tally.add(now < before);
  return tally;
}

/// |kappa| at the k-th a over that at the first.
std::vector<double> ratios(const Rows& rows, std::size_t k) {
  std::vector<double> found;
  for (const auto& [first, now] :
       rows.pairs(magnitude, shape_key(figure_shapes[0].words), shape_key(figure_shapes[k].words)))
    found.push_back(now / first);
  return found;
}

Table inflection_table(const Findings& found) {
  Table table("inflections", "Curvature at inflection joints",
              "Over the joints that are inflections at all four a. Curvature and jump times the mean chord of the "
              "points; the peak is the larger |κ| at the two points beside the joint. The factor of Eq. (8) is (1 - a) "
              "/ a² over its value at 2/3: what a alone does, with legs and areas unchanged.");
  table.words("drawing").words("a").numbers("a as a number").counts("joints");
  table.numbers("median |κ|").numbers("median jump").numbers("median jump over peak");
  table.numbers("median ratio to 2/3").numbers("largest ratio to 2/3").numbers("factor of Eq. (8)");
  const auto add_rows = [&](const std::string& words, const Rows& rows) {
    for (std::size_t k = 0; k < figure_shapes.size(); ++k) {
      const auto& [a, name] = figure_shapes[k];
      const Rows joints = rows.where({shape_key(name)});
      const std::vector<double> ratio = ratios(rows, k);
      table.row({words, name, a, joints.size(), joints.median(magnitude), joints.median(gap),
                 joints.median(gap_over_peak), median(ratio), largest(ratio), (1.0 - a) / (a * a) * 4.0 / 3.0});
    }
  };
  for (const std::string& drawing : found.drawn())
    add_rows(drawing, found.rows().where({study::key::dataset(drawing)}));
  add_rows("all drawings", found.rows());
  return table;
}

Table steps_table(const Findings& found) {
  Table table("steps", "Joints where the jump shrinks from one a to the next",
              "Over all drawings; joints that are inflections at all four a.");
  table.words("step").counts("joints").counts("smaller |κ|").counts("smaller jump");
  for (std::size_t k = 1; k < figure_shapes.size(); ++k)
    table.row({fmt::format("{} to {}", figure_shapes[k - 1].words, figure_shapes[k].words),
               falls(found.rows(), gap, k).cases, falls(found.rows(), magnitude, k).agree,
               falls(found.rows(), gap, k).agree});
  return table;
}

Table continuity_table(const Findings& found) {
  Table table(
      "continuity", "What joints keep",
      "All drawings at all four a. Jumps of curvature relative to the larger side (or to one over the length of "
      "the curve, if that is more); angles in radians. At inflections the jump of |κ|.");
  table.words("joints").counts("number").numbers("largest angle", "rad").numbers("largest jump");
  for (const auto& [words, of_kind] : {std::pair("at inflections", at_inflection), std::pair("elsewhere", elsewhere)}) {
    const Rows joints = found.rows().where({kind(of_kind)});
    table.row({words, joints.size(), joints.largest(angle), joints.largest(jump)});
  }
  return table;
}

/// |kappa| at the end of the segment before a joint.
double curvature_at_joint(const store::CurveRecord& curve, std::size_t joint) {
  return std::abs(
      curve.sample_kappa[static_cast<std::size_t>((curve.joint_segment[joint] + 1) * curve.samples_per_segment - 1)]);
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

/// A close-up at the joint of `curve` nearest to a place.
std::vector<double> close_up(const store::CurveRecord& curve, const Vec2& place) {
  std::vector<double> distance;
  for (std::size_t j = 0; j < curve.joint_x.size(); ++j)
    distance.push_back((Vec2(curve.joint_x[j], curve.joint_y[j]) - place).norm());
  const auto j = static_cast<std::size_t>(std::ranges::min_element(distance) - distance.begin());
  return window_at(curve, curve.joint_x[j], curve.joint_y[j], 0.16);
}

/// Fig. 7: the four curves with combs, and below each the close-up at an inflection.
store::FigureRecord curves_figure(const Findings& found, const std::string& drawing) {
  store::FigureRecord figure{
      .id = "ekappa-inflection-" + drawing,
      .title = "Curvature at inflections: " + drawing,
      .caption =
          "Top: the κ-curve and εκ-curves with their curvature combs, to one scale. Bottom: close-ups at the "
          "inflection with the largest jump (the frame above), combs six times as long. The comb changes sides "
          "at the joint; the step is the G2 error, and shrinks as a grows.",
      .columns = static_cast<int>(figure_shapes.size())};
  std::vector<store::PanelRecord> close_ups;
  std::optional<Vec2> place;
  for (const Shape& shape : figure_shapes) {
    const auto cell = found.find(drawing, label_of_shape(shape));
    if (!cell) continue;
    figure.panels.push_back(Panel::curves({*cell}, label_of_shape(shape)).comb(0.2));
    const store::CurveRecord* curve = found.curve(*cell);
    if (curve == nullptr) continue;
    if (const auto j = joint_to_show(*curve); j && !place) place = Vec2(curve->joint_x[*j], curve->joint_y[*j]);
    if (place)
      close_ups.push_back(Panel::curves({*cell}, "close-up, " + label_of_shape(shape))
                              .comb(6.0 * 0.2)
                              .window(close_up(*curve, *place)));
  }
  std::ranges::move(close_ups, std::back_inserter(figure.panels));
  return figure;
}

/// Curvature along a drawing, a stretch around the inflection with the largest jump.
std::optional<Panel> curvature_panel(const Findings& found, const std::string& drawing) {
  std::vector<int> cells;
  for (const Shape& shape : figure_shapes)
    if (const auto cell = found.find(drawing, label_of_shape(shape))) cells.push_back(*cell);
  const store::CurveRecord* curve = cells.empty() ? nullptr : found.curve(cells.front());
  if (curve == nullptr) return std::nullopt;
  Panel panel = Panel::curvature(cells, drawing + ", at the inflection").of_curve(0);
  if (const auto j = joint_to_show(*curve)) {
    const double s = curve->joint_s[*j] / curve->sample_s.back(), kappa = 4.0 * curvature_at_joint(*curve, *j);
    panel = std::move(panel).window({s - 0.18, s + 0.18, -kappa, kappa});
  }
  return panel;
}

store::FigureRecord numbers_figure(const Findings& found) {
  store::FigureRecord figure{
      .id = "ekappa-inflection-numbers",
      .title = "Jump of curvature at inflections against a",
      .caption =
          "Left: curvature along the curve around an inflection; the jump is the gap between the two ends at the "
          "joint. Right: the median jump at inflection joints, against a.",
      .columns = 2};
  const auto drawings = found.drawn();
  if (auto panel = drawings.empty() ? std::nullopt : curvature_panel(found, drawings.front()))
    figure.panels.push_back(std::move(*panel));
  figure.panels.push_back(Panel::graph("inflections", "a as a number", {"median jump"}, "jump at inflections")
                              .series("drawing")
                              .log_y()
                              .labels("a", "median jump × mean chord"));
  return figure;
}

/// |kappa| or its jump at inflections shrinks: what generally happens, exceptions counted.
void claim_shrinking(Findings& found, std::string_view id, const Quantity& what) {
  Tally steps;
  std::vector<std::string> medians;
  for (std::size_t k = 1; k < figure_shapes.size(); ++k) {
    steps += falls(found.rows(), what, k);
    medians.push_back(fmt::format("{:.3g} at {}", median(ratios(found.rows(), k)), figure_shapes[k].words));
  }
  found.judge(
      id, steps,
      {fmt::format("smaller in {} steps; median ratio to a = 2/3: {}", steps.words(), fmt::join(medians, ", ")),
       fmt::format("{:.0f} joints of all drawings that are inflections at a = 2/3, 0.75, 0.85 and 0.95, three "
                   "steps each; in {:.0f} steps it grows. {:.0f} joints are inflections at some a only and left "
                   "out. The magnitudes agree on both sides, so the jump is twice |κ|.",
                   steps.cases / 3.0, steps.cases - steps.agree, found.rows().total(at_some_a_only))});
}

void claim_continuity(Findings& found) {
  const Rows inflections = found.rows().where({kind(at_inflection)}), others = found.rows().where({kind(elsewhere)});
  const auto joints = static_cast<double>(inflections.size() + others.size());
  const Tally kept{joints - inflections.total(missed) - others.total(missed), joints};
  const Rows misses =
      found.rows().where_row([](const study::Row& row) { return row.has(missed) && row[missed] > 0.0; });
  const std::vector<std::string> where = misses.words_of(study::key::dataset);
  found.judge(
      "g2-except-inflections", kept,
      {kept.words() + " joints",
       fmt::format("{} joints elsewhere: largest relative jump of curvature {:.2g}, largest angle {:.2g} rad; "
                   "{} joints at inflections: largest angle {:.2g} rad, |κ| agrees to {:.2g} but has opposite "
                   "signs. A miss is what rounding of the control points does not explain "
                   "(metrics/README.md, continuity){}{}. {:.0f} of {} fits are left out: no solution found or input "
                   "that a scheme cannot take.",
                   others.size(), others.largest(jump), others.largest(angle), inflections.size(),
                   inflections.largest(angle), inflections.largest(jump), where.empty() ? "" : "; the misses are in ",
                   fmt::join(where, ", "), found.rows().total(unsolved), found.rows().values(unsolved).size())});
}

void conclude(Findings& found) {
  found.add(inflection_table(found));
  found.add(steps_table(found));
  found.add(continuity_table(found));
  for (const std::string& drawing : found.drawn()) found.add(curves_figure(found, drawing));
  found.add(numbers_figure(found));
  claim_continuity(found);
  claim_shrinking(found, "inflection-curvature-shrinks", magnitude);
  claim_shrinking(found, "inflection-gap-shrinks", gap);
}

}  // namespace

Experiment ekappa_inflection_experiment() {
  return study::experiment(
      {.id = "ekappa-inflection",
       .title = "Curvature at inflections as a grows (Miura 2022, Fig. 7)",
       .about = std::string(about),
       .paper = std::string(paper),
       .claims = {"g2-except-inflections", "inflection-curvature-shrinks", "inflection-gap-shrinks"},
       .jobs = jobs,
       .conclude = conclude});
}

}  // namespace kappabench
