#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/papers/intrinsic-2022-yoshida/common.hpp"
#include "experiments/papers/intrinsic-2022-yoshida/inputs.hpp"
#include "experiments/study/summaries.hpp"
#include "schemes/curve/jet.hpp"
#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench {

using namespace yoshida;
using namespace intrinsic;

namespace {

constexpr std::string_view about =
    "The first and the last of six control curvatures are solved for so that the curve meets both points and tangents; "
    "the others follow by Eqs. (10) and (11), written in Greville abscissae throughout, for p from -1 to 1: curvature "
    "should be monotone for every p. With four control curvatures of which the end pairs are equal, it should be level "
    "at both ends (Fig. 3(f)). The paper prints no conditions; the ones drawn are stand-ins. What holds in general is "
    "counted on random conditions: the paper's angles, and any up to 0.95 pi from the chord. Data that do not turn "
    "(theta_d = 0) have a length, too, but Eq. (8) is 0/0 there.";

constexpr int version = 1;
constexpr long conditions = 1500;  ///< of each kind, unless the plan says otherwise
constexpr std::string_view dataset_name = "random-g1";
constexpr std::array shown_p{-1.0, -0.5, 0.0, 0.5, 1.0};
constexpr int points_compared = 65;

/// Curvature that rises from next to nothing, as in the paper's figure.
StandardData drawn_condition() {
  constexpr double degree = std::numbers::pi / 180.0;
  return {25.0 * degree, 75.0 * degree, {}, {}};
}

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
  const Solved solved = knots.solve(data);
  return judged(data, knots.curve(solved), solved.iterations, solved.converged);
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

/// A failure that a reader can repeat.
void put_failure(const StandardData& data, double p, const HermiteFit& fit, store::CellRecord& cell) {
  study::put(cell, "failure: chord angle", data.chord_angle);
  study::put(cell, "failure: turning", data.turning);
  study::put(cell, "failure: p", p);
  study::put(cell, "failure: gap", fit.residual, kappabench::Method::sampled);
}

/// Sums over the conditions of a cell: so many of them that each cannot have a row.
struct Sums {
  double fits = 0.0, solved = 0.0, not_monotone = 0.0, inflected = 0.0, conditions = 0.0, reshaped = 0.0;
  double level = 0.0, levelled = 0.0, largest_gap = 0.0, largest_end_slope = 0.0;
  double length_agrees = 0.0, lengths = 0.0;
};

void add_condition(const StandardData& data, Sums& sums, store::CellRecord& cell) {
  sums.conditions += 1.0;
  std::vector<std::vector<Vec2>> shapes;
  for (const double p : shown_p) {
    const HermiteFit fit = solve(data, with_p(p));
    sums.fits += 1.0;
    if (fit.outcome != Outcome::converged) {
      put_failure(data, p, fit, cell);
      continue;
    }
    sums.solved += 1.0;
    sums.largest_gap = std::max(sums.largest_gap, fit.residual);
    sums.not_monotone += monotone(fit) ? 0.0 : 1.0;
    // A monotone curvature has an inflection where its ends have opposite signs.
    sums.inflected += fit.curve->controls.front() * fit.curve->controls.back() < 0.0 ? 1.0 : 0.0;
    if (p != shown_p[1] && p != shown_p[3]) shapes.push_back(points_of(*fit.curve, data));
    if (p != 0.0) continue;
    const std::vector<double> w = basis_integrals(fit.curve->basis);
    double integral = 0.0;
    for (std::size_t i = 0; i < w.size(); ++i) integral += w[i] * fit.curve->controls[i];
    sums.lengths += 1.0;
    sums.length_agrees += std::abs(data.turning / integral - fit.curve->length) <= 1e-9 * fit.curve->length ? 1.0 : 0.0;
  }
  if (shapes.size() == 3)
    sums.reshaped +=
        std::min(largest_distance(shapes[0], shapes[1]), largest_distance(shapes[2], shapes[1])) > 1e-3 ? 1.0 : 0.0;
  const HermiteFit level = level_ended(data);
  if (level.outcome != Outcome::converged) return;
  const double slope = end_slope(*level.curve, data);
  sums.level += 1.0;
  sums.levelled += slope <= 1e-9 ? 1.0 : 0.0;
  sums.largest_end_slope = std::max(sums.largest_end_slope, slope);
}

void put_sums(const Sums& sums, store::CellRecord& cell) {
  for (const auto& [column, value] :
       {std::pair{"conditions", sums.conditions}, std::pair{"fits", sums.fits}, std::pair{"solved", sums.solved},
        std::pair{"not monotone", sums.not_monotone}, std::pair{"inflected", sums.inflected},
        std::pair{"reshaped", sums.reshaped}, std::pair{"level fits", sums.level},
        std::pair{"level ends", sums.levelled}, std::pair{"lengths", sums.lengths},
        std::pair{"lengths by Eq. (8)", sums.length_agrees}})
    study::put(cell, column, value);
  study::put(cell, "largest gap", sums.largest_gap, kappabench::Method::sampled);
  study::put(cell, "largest end slope", sums.largest_end_slope, kappabench::Method::sampled);
}

/// Symmetric S-shapes: the tangents at both ends are parallel.
void measure_without_turning(store::CellRecord& cell) {
  constexpr int steps = 200;
  for (int i = 1; i <= steps; ++i) {
    const StandardData data{0.5 * std::numbers::pi * i / steps, 0.0, {}, {}};
    const HermiteFit fit = solve(data);
    Settings simplex;
    simplex.method = intrinsic::Method::simplex;
    study::put(cell, "parallel tangents", 1.0);
    study::put(cell, "parallel tangents solved", fit.outcome == Outcome::converged ? 1.0 : 0.0);
    study::put(cell, "parallel tangents by Eq. (8)", solve(data, simplex).outcome == Outcome::converged ? 1.0 : 0.0);
  }
}

std::string dataset_of(double p) { return fmt::format("G1 condition, p = {:g}", p); }
constexpr std::string_view level_dataset = "G1 condition, level ends";

std::vector<CellJob> jobs(const Context& context) {
  const SchemePtr scheme = context.registry.create("intrinsic");
  std::vector<CellJob> jobs;
  const auto add = [&jobs](std::vector<CellJob> more) { std::ranges::move(more, std::back_inserter(jobs)); };
  const StandardData data = drawn_condition();
  for (const double p : shown_p)
    add(drawn_jobs(scheme, dataset_of(p), "curve", version,
                   [data, p] { return as_fit(data, solve(data, with_p(p))); }));
  add(drawn_jobs(scheme, std::string(level_dataset), "curve", version,
                 [data] { return as_fit(data, level_ended(data)); }));
  constexpr long part = 5000;
  const long wanted = amounts(context, "intrinsic-g1", {{dataset_name, conditions}}).front();
  const std::uint64_t seed = context.seed;
  for (const Angles angles : {Angles::ordinary, Angles::any})
    for (long from = 0; from < wanted; from += part) {
      const long to = std::min(from + part, wanted);
      jobs.push_back(
          numbers_job(scheme, std::string(name(angles)), fmt::format("conditions {} to {}, seed {}", from, to, seed),
                      version, [angles, from, to, seed](store::CellRecord& cell) {
                        Sums sums;
                        for (long i = from; i < to; ++i)
                          add_condition(random_angles(angles, seed, static_cast<std::uint64_t>(i)), sums, cell);
                        put_sums(sums, cell);
                      }));
    }
  jobs.push_back(numbers_job(scheme, "parallel tangents", "parallel tangents", version, measure_without_turning));
  return jobs;
}

store::TableRecord table(const store::ExperimentRecord& record) {
  TableBuilder builder("conditions", "Random G1 conditions",
                       "Every condition with p = -1, -0.5, 0, 0.5, 1 and six control curvatures. Gap: how far the end "
                       "is missed, in chords and radians.");
  builder.words("angles against the chord").counts("conditions").counts("fits").counts("solved");
  builder.counts("not monotone").counts("with inflection").numbers("largest gap").counts("level ends solved");
  builder.numbers("largest slope at level ends");
  for (const Angles angles : {Angles::ordinary, Angles::any}) {
    const std::string_view dataset = name(angles);
    if (study::values(record, "fits", dataset).empty()) continue;
    builder.row({std::string(dataset), study::total(record, "conditions", dataset),
                 study::total(record, "fits", dataset), study::total(record, "solved", dataset),
                 study::total(record, "not monotone", dataset), study::total(record, "inflected", dataset),
                 largest(study::values(record, "largest gap", dataset)), study::total(record, "level fits", dataset),
                 largest(study::values(record, "largest end slope", dataset))});
  }
  return builder.table();
}

store::TableRecord failure_table(const store::ExperimentRecord& record) {
  constexpr std::size_t most = 50;
  const auto angle = study::values(record, "failure: chord angle"), turning = study::values(record, "failure: turning"),
             p = study::values(record, "failure: p"), missed = study::values(record, "failure: gap");
  TableBuilder builder("failures", "Conditions without a solution",
                       fmt::format("{} in all; at most {} are listed. Radians, and chords.", angle.size(), most));
  builder.numbers("theta_e").numbers("theta_d").numbers("p").numbers("gap");
  for (std::size_t i = 0; i < std::min(angle.size(), most); ++i) builder.row({angle[i], turning[i], p[i], missed[i]});
  return builder.table();
}

store::FigureRecord figure(const store::ExperimentRecord& record) {
  store::FigureRecord figure{
      .id = "intrinsic-g1",
      .title = "G1 interpolation with different p",
      .caption =
          "One stand-in condition (theta_e = 25 degrees, theta_d = 75 degrees) with p = -1, -0.5, 0, 0.5, 1 and "
          "six control curvatures, and with four of which the end pairs are equal. Below: curvature over arc "
          "length; squares are control curvatures over their Greville abscissae, ticks knots.",
      .columns = 6,
      .panels = {}};
  for (const double p : shown_p) add_curve_panel(figure, record, dataset_of(p), fmt::format("p = {:g}", p));
  add_curve_panel(figure, record, level_dataset, "level ends");
  for (const double p : shown_p) add_curvature_panel(figure, record, dataset_of(p), fmt::format("p = {:g}", p));
  add_curvature_panel(figure, record, level_dataset, "level ends");
  return figure;
}

store::ClaimRecord monotone_claim(const store::ExperimentRecord& record) {
  const double solved = study::total(record, "solved"), wrong = study::total(record, "not monotone");
  return claim("monotone-for-p", study::verdict_for_all(wrong, solved),
               fmt::format("{} monotone", study::share(solved - wrong, solved)),
               fmt::format("{:.0f} random conditions with five values of p each, {} solved; the curvature function is "
                           "checked span by span.",
                           study::total(record, "conditions"), study::share(solved, study::total(record, "fits"))));
}

store::ClaimRecord inflection_claim(const store::ExperimentRecord& record) {
  const double inflected = study::total(record, "inflected", name(Angles::ordinary)),
               solved = study::total(record, "solved", name(Angles::ordinary));
  return claim("inflection-may-appear", inflected > 0.0 ? "reproduced" : "not reproduced",
               fmt::format("{} have one", study::share(inflected, solved)),
               "Curves for the paper's angles, whose ends both turn left.");
}

store::ClaimRecord level_claim(const store::ExperimentRecord& record) {
  const double cases = study::total(record, "level fits"), level = study::total(record, "level ends");
  return claim(
      "level-ends", study::verdict_for_all(cases - level, cases),
      fmt::format("{} have d kappa/ds = 0 at both ends", study::share(level, cases)),
      fmt::format("At most {:.2g} of the largest slope of curvature (or the largest curvature over the chord), from "
                  "the curve's third derivative. {} "
                  "conditions have a solution with four controls tied in pairs.",
                  largest(study::values(record, "largest end slope")),
                  study::share(cases, study::total(record, "conditions"))));
}

store::ClaimRecord shape_claim(const store::ExperimentRecord& record) {
  const double reshaped = study::total(record, "reshaped"), cases = study::total(record, "conditions");
  return claim("p-changes-shape", study::verdict_in_general(reshaped, cases),
               fmt::format("{} move by more than 1e-3 chords", study::share(reshaped, cases)),
               "The smaller of the largest distances of the curves with p = -1 and p = 1 from that with p = 0; a curve "
               "that is nearly a circular arc cannot change.");
}

store::ClaimRecord length_claim(const store::ExperimentRecord& record) {
  const double parallel = study::total(record, "parallel tangents"),
               by_formula = study::total(record, "parallel tangents by Eq. (8)");
  const double lengths = study::total(record, "lengths"), agree = study::total(record, "lengths by Eq. (8)");
  return claim(
      "length-from-turning", study::verdict_for_all(parallel - by_formula + lengths - agree, parallel + lengths),
      fmt::format("with theta_d = 0: {}", study::share(by_formula, parallel)),
      fmt::format("Conditions with parallel tangents that the simplex solves with the length from Eq. (8), 0/0 "
                  "there; Newton's method on the dimensionless equations solves {}. For random conditions Eq. "
                  "(8) gives the length to 1e-9 in {}.",
                  study::share(study::total(record, "parallel tangents solved"), parallel),
                  study::share(agree, lengths)));
}

void conclude(const Context&, store::ExperimentRecord& record) {
  record.tables = {drawn_table(record), table(record), failure_table(record)};
  if (auto drawn = figure(record); !drawn.panels.empty()) record.figures = {std::move(drawn)};
  record.claims = {monotone_claim(record), inflection_claim(record), level_claim(record), shape_claim(record),
                   length_claim(record)};
}

}  // namespace

Experiment intrinsic_g1_experiment() {
  return {.id = "intrinsic-g1",
          .title = "G1 Hermite interpolation (Yoshida 2022, Fig. 3)",
          .about = std::string(about),
          .jobs = jobs,
          .conclude = conclude};
}

}  // namespace kappabench
