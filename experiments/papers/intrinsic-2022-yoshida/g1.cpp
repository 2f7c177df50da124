// Yoshida 2022, Fig. 3: G1 Hermite interpolation with different p, and curvature that is level at both ends.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/study/experiment.hpp"
#include "experiments/study/jobs.hpp"
#include "schemes/curve/jet.hpp"
#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {
namespace {

using namespace yoshida;
using namespace intrinsic;
using kappabench::Method;
using study::count_of, study::Findings, study::Key, study::Notes, study::Quantity, study::Row, study::Rows,
    study::Table, study::Tally;

constexpr std::string_view about =
    "The first and the last of six control curvatures are solved for so that the curve meets both points and tangents; "
    "the others follow by Eqs. (10) and (11), written in Greville abscissae throughout, for p from -1 to 1: curvature "
    "should be monotone for every p. With four control curvatures of which the end pairs are equal, it should be level "
    "at both ends (Fig. 3(f)). The paper prints no conditions; the ones drawn are stand-ins. What holds in general is "
    "counted on random conditions: the paper's angles, and any up to 0.95 pi from the chord. Data that do not turn "
    "(theta_d = 0) have a length, too, but Eq. (8) is 0/0 there.";

// ---- what is measured

constexpr long conditions_of_a_kind = 1500;  ///< unless the plan says otherwise
constexpr std::array both{Angles::ordinary, Angles::any};
constexpr std::array shown_p{-1.0, -0.5, 0.0, 0.5, 1.0};
constexpr int points_compared = 65;

/// A failure that a reader can repeat.
const Key chord_angle{"chord angle"}, turning{"turning"}, with{"p"};
const Quantity failure_gap{"failure: gap", "1", Method::sampled};
/// Sums over the conditions of a cell: so many of them that each cannot have a row.
const Quantity conditions = count_of("conditions"), fits = count_of("fits"), solved = count_of("solved"),
               not_monotone = count_of("not monotone"), inflected = count_of("inflected");
const Quantity reshaped{"reshaped", "1", Method::sampled};
const Quantity level_fits = count_of("level fits");
const Quantity level_ends{"level ends", "1", Method::sampled};
// "By Eq. (8)" is decided by the distance of two lengths that both come from quadrature.
const Quantity lengths = count_of("lengths"),
               lengths_by_formula{"lengths by Eq. (8)", "1", kappabench::Method::sampled};
const Quantity largest_gap{"largest gap", "1", Method::sampled};
const Quantity largest_end_slope{"largest end slope", "1", Method::sampled};
/// Symmetric S-shapes: the tangents at both ends are parallel.
const Quantity parallel = count_of("parallel tangents"), parallel_solved = count_of("parallel tangents solved"),
               parallel_by_formula{"parallel tangents by Eq. (8)", "1", kappabench::Method::sampled};

Settings with_p(double p) {
  Settings settings;
  settings.p = p;
  return settings;
}

/// Fig. 3(f): four control curvatures, the second like the first and the third like the last.
HermiteFit level_ended(const StandardData& data) {
  const BSplineBasis basis = uniform_basis(3, 4);
  ControlRule rule = interpolated(basis, 0, 3, 0.0);
  tie(rule, 1, 0);
  tie(rule, 2, 3);
  const FixedKnots knots(basis, rule);
  const Solved tied = knots.solve(data);
  return judged(data, knots.curve(tied), tied.iterations, tied.converged);
}

IntrinsicSegment segment_of(const StandardCurve& curve, const StandardData& data) {
  return IntrinsicSegment(placed(curve, placed_at_origin(data)));
}

std::vector<Vec2> points_of(const StandardCurve& curve, const StandardData& data) {
  const IntrinsicSegment segment = segment_of(curve, data);
  std::vector<Vec2> points;
  points.reserve(points_compared);
  for (int i = 0; i < points_compared; ++i)
    points.push_back(segment.jet(static_cast<double>(i) / (points_compared - 1), 0).position());
  return points;
}

double largest_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

/// |d kappa / ds| at the ends over its largest value along the curve, or over the largest curvature times the chord if
/// that is more: the slopes of a nearly circular arc are all rounding.
double end_slope(const StandardCurve& curve, const StandardData& data) {
  const IntrinsicSegment segment = segment_of(curve, data);
  double largest = largest_control(curve);
  for (int i = 1; i + 1 < points_compared; ++i)
    largest = std::max(largest,
                       std::abs(curvature_derivative(segment.jet(static_cast<double>(i) / (points_compared - 1), 3))));
  const double ends = std::max(std::abs(curvature_derivative(segment.jet(0.0, 3))),
                               std::abs(curvature_derivative(segment.jet(1.0, 3))));
  return largest > 0.0 ? ends / largest : 0.0;
}

/// What the rows of a cell are summed up from.
struct Sums {
  Tally solved, monotone, inflected, reshaped, level, lengths;
  double largest_gap = 0.0, largest_end_slope = 0.0;
};

/// Does the length follow from the turning, Eq. (8)?
bool length_follows(const StandardCurve& curve, const StandardData& data) {
  const std::vector<double> w = basis_integrals(curve.basis);
  double integral = 0.0;
  for (std::size_t i = 0; i < w.size(); ++i) integral += w[i] * curve.controls[i];
  return std::abs(data.turning / integral - curve.length) <= 1e-9 * curve.length;
}

void add_condition(const StandardData& data, Sums& sums, Notes& notes) {
  std::vector<std::vector<Vec2>> shapes;
  for (const double p : shown_p) {
    const HermiteFit fit = solve(data, with_p(p));
    sums.solved.add(fit.outcome == Outcome::converged);
    if (fit.outcome != Outcome::converged) {
      notes.row({chord_angle(data.chord_angle), turning(data.turning), with(p)}, {failure_gap(fit.residual)});
      continue;
    }
    sums.largest_gap = std::max(sums.largest_gap, fit.residual);
    sums.monotone.add(monotone(fit));
    // A monotone curvature has an inflection where its ends have opposite signs.
    sums.inflected.add(fit.curve->controls.front() * fit.curve->controls.back() < 0.0);
    if (p == -1.0 || p == 0.0 || p == 1.0) shapes.push_back(points_of(*fit.curve, data));
    if (p == 0.0) sums.lengths.add(length_follows(*fit.curve, data));
  }
  sums.reshaped.add(shapes.size() == 3 &&
                    std::min(largest_distance(shapes[0], shapes[1]), largest_distance(shapes[2], shapes[1])) > 1e-3);
  const HermiteFit level = level_ended(data);
  if (level.outcome != Outcome::converged) return;
  const double slope = end_slope(*level.curve, data);
  sums.level.add(slope <= 1e-9);
  sums.largest_end_slope = std::max(sums.largest_end_slope, slope);
}

void measure_conditions(const Uses& uses, Notes& notes) {
  const Angles angles = angles_named(uses.words.at("angles"));
  const auto to = static_cast<std::uint64_t>(uses.numbers.at("to"));
  Sums sums;
  for (auto i = static_cast<std::uint64_t>(uses.numbers.at("from")); i < to; ++i)
    add_condition(random_angles(angles, uses.seed, i), sums, notes);
  notes.row({}, {conditions(sums.reshaped.cases), fits(sums.solved.cases), solved(sums.solved.agree),
                 not_monotone(sums.monotone.misses()), inflected(sums.inflected.agree), reshaped(sums.reshaped.agree),
                 level_fits(sums.level.cases), level_ends(sums.level.agree), lengths(sums.lengths.cases),
                 lengths_by_formula(sums.lengths.agree), largest_gap(sums.largest_gap),
                 largest_end_slope(sums.largest_end_slope)});
}

void measure_without_turning(const Uses&, Notes& notes) {
  constexpr int steps = 200;
  Settings simplex;
  simplex.method = intrinsic::Method::simplex;
  for (int i = 1; i <= steps; ++i) {
    const StandardData data{0.5 * std::numbers::pi * i / steps, 0.0, {}, {}};
    const auto solved_by = [&data](const Settings& by) {
      return solve(data, by).outcome == Outcome::converged ? 1 : 0;
    };
    notes.row({chord_angle(data.chord_angle)},
              {parallel(1), parallel_solved(solved_by({})), parallel_by_formula(solved_by(simplex))});
  }
}

Fit fit_with_p(const Uses& uses) {
  const StandardData data = condition_of_figure_3();
  return as_fit(data, solve(data, with_p(uses.numbers.at("p"))));
}
Fit fit_with_level_ends(const Uses&) { return as_fit(condition_of_figure_3(), level_ended(condition_of_figure_3())); }

std::string dataset_of(double p) { return fmt::format("G1 condition, p = {:g}", p); }
constexpr std::string_view level_dataset = "G1 condition, level ends";

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  for (const double p : shown_p)
    draw<fit_with_p>(jobs, {.work = "G1 condition", .schemes = {scheme}, .numbers = {{"p", p}}}, dataset_of(p));
  draw<fit_with_level_ends>(jobs, {.work = "G1 condition, level ends", .schemes = {scheme}},
                            std::string(level_dataset));
  const long wanted = amounts(context, "intrinsic-g1", {{"random-g1", conditions_of_a_kind}}).front();
  for (const Angles angles : both)
    for (const auto& [from, to] : parts_of(wanted))
      jobs.push_back(study::numbers_job<measure_conditions>(
          {.work = "G1 conditions",
           .schemes = {scheme},
           .seed = context.seed,
           .numbers = {{"from", static_cast<double>(from)}, {"to", static_cast<double>(to)}},
           .words = {{"angles", std::string(name(angles))}}},
          std::string(name(angles)), fmt::format("conditions {} to {}, seed {}", from, to, context.seed)));
  jobs.push_back(study::numbers_job<measure_without_turning>({.work = "parallel tangents", .schemes = {scheme}},
                                                             "parallel tangents"));
  return jobs;
}

// ---- what follows

Rows rows_of(const Findings& found, Angles angles) { return found.rows().where({study::key::dataset(name(angles))}); }

Table condition_table(const Findings& found) {
  Table table("conditions", "Random G1 conditions",
              "Every condition with p = -1, -0.5, 0, 0.5, 1 and six control curvatures. Gap: how far the end "
              "is missed, in chords and radians.");
  table.words("angles against the chord").counts("conditions").counts("fits").counts("solved");
  table.counts("not monotone").counts("with inflection").numbers("largest gap").counts("level ends solved");
  table.numbers("largest slope at level ends");
  for (const Angles angles : both) {
    const Rows rows = rows_of(found, angles);
    if (rows.empty()) continue;
    table.row({name(angles), rows.total(conditions), rows.total(fits), rows.total(solved), rows.total(not_monotone),
               rows.total(inflected), rows.largest(largest_gap), rows.total(level_fits),
               rows.largest(largest_end_slope)});
  }
  return table;
}

Table failure_table(const Findings& found) {
  constexpr std::size_t most = 50;
  const Rows failures = found.rows().where_row([](const Row& row) { return row.has(failure_gap); });
  Table table("failures", "Conditions without a solution",
              fmt::format("{} in all; at most {} are listed. Radians, and chords.", failures.size(), most));
  table.numbers("theta_e").numbers("theta_d").numbers("p").numbers("gap");
  const auto number = [](const Row& row, const Key& key) { return std::get<double>(row[key]); };
  std::size_t listed = 0;
  for (const Row* row : failures)
    if (++listed <= most)
      table.row({number(*row, chord_angle), number(*row, turning), number(*row, with), (*row)[failure_gap]});
  return table;
}

store::FigureRecord figure(const Findings& found) {
  store::FigureRecord figure{
      .id = "intrinsic-g1",
      .title = "G1 interpolation with different p",
      .caption =
          "One stand-in condition (theta_e = 25 degrees, theta_d = 75 degrees) with p = -1, -0.5, 0, 0.5, 1 and "
          "six control curvatures, and with four of which the end pairs are equal. Below: curvature over arc "
          "length; squares are control curvatures over their Greville abscissae, ticks knots.",
      .columns = 6,
      .panels = {}};
  for (const double p : shown_p) add_curve_panel(figure, found, dataset_of(p), fmt::format("p = {:g}", p));
  add_curve_panel(figure, found, level_dataset, "level ends");
  for (const double p : shown_p) add_curvature_panel(figure, found, dataset_of(p), fmt::format("p = {:g}", p));
  add_curvature_panel(figure, found, level_dataset, "level ends");
  return figure;
}

void claim_monotone(Findings& found) {
  const Rows& rows = found.rows();
  const Tally monotone{rows.total(solved) - rows.total(not_monotone), rows.total(fits)},
      tried{rows.total(solved), rows.total(fits)};
  found.judge("monotone-for-p", monotone,
              {fmt::format("{} monotone", monotone.words()),
               fmt::format("{:.0f} random conditions with five values of p each, {} solved, the others misses; the "
                           "curvature function is checked span by span.",
                           rows.total(conditions), tried.words())});
}

void claim_inflection(Findings& found) {
  const Rows rows = rows_of(found, Angles::ordinary);
  const Tally tally{rows.total(inflected), rows.total(fits)};
  found.judge("inflection-may-appear", tally,
              {fmt::format("{} have one", tally.words()), "Curves for the paper's angles, whose ends both turn left."});
}

void claim_level(Findings& found) {
  const Rows& rows = found.rows();
  const Tally level{rows.total(level_ends), rows.total(level_fits)},
      tied{rows.total(level_fits), rows.total(conditions)};
  found.by_construction(
      "level-ends",
      {fmt::format("{} have d kappa/ds = 0 at both ends", level.words()),
       fmt::format(
           "The derivative at an end is a multiple of the difference of the two controls there, which are equal. "
           "On the curve it is at most {:.2g} of the largest slope of curvature (or the largest curvature over "
           "the chord). {} conditions have a solution with four controls tied in pairs.",
           rows.largest(largest_end_slope), tied.words())});
}

void claim_shape(Findings& found) {
  const Tally tally{found.rows().total(reshaped), found.rows().total(conditions)};
  found.judge("p-changes-shape", tally,
              {fmt::format("{} move by more than 1e-3 chords", tally.words()),
               "The smaller of the largest distances of the curves with p = -1 and p = 1 from that with p = 0; a curve "
               "that is nearly a circular arc cannot change."});
}

/// Eq. (8) says nothing where it is 0/0, so that no case of theta_d = 0 speaks against it.
void claim_length(Findings& found) {
  const Rows& rows = found.rows();
  const Tally by_formula{rows.total(parallel_by_formula), rows.total(parallel)},
      by_newton{rows.total(parallel_solved), rows.total(parallel)},
      agree{rows.total(lengths_by_formula), rows.total(conditions)};
  found.judge(
      "length-from-turning", agree,
      {fmt::format("{} lengths to 1e-9; undefined for theta_d = 0", agree.words()),
       fmt::format("Random conditions, p = 0. With parallel tangents (theta_d = 0) Eq. (8) is 0/0: the simplex, "
                   "which takes the length from it, solves {}, Newton's method on the dimensionless equations {}.",
                   by_formula.words(), by_newton.words())});
}

void conclude(Findings& found) {
  found.add(drawn_table(found));
  found.add(condition_table(found));
  found.add(failure_table(found));
  found.add(figure(found));
  claim_monotone(found);
  claim_inflection(found);
  claim_level(found);
  claim_shape(found);
  claim_length(found);
}

}  // namespace

Experiment intrinsic_g1_experiment() {
  return study::experiment(
      {.id = "intrinsic-g1",
       .title = "G1 Hermite interpolation (Yoshida 2022, Fig. 3)",
       .about = std::string(about),
       .paper = std::string(paper),
       .claims = {"monotone-for-p", "inflection-may-appear", "level-ends", "p-changes-shape", "length-from-turning"},
       .jobs = jobs,
       .conclude = conclude});
}

}  // namespace kappabench
