#include "schemes/intrinsic/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "schemes/curve/exact_curvature.hpp"
#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/intrinsic/monotone_family.hpp"
#include "schemes/intrinsic/simplex.hpp"
#include "schemes/intrinsic/viable_region.hpp"
#include "schemes/segments/intrinsic.hpp"

namespace kappabench::intrinsic {

namespace {

/// Controls that differ by the solver's rounding are equal.
IntrinsicSegment cleaned(StandardCurve curve) {
  const double rounding = 1e-12 * largest_control(curve);
  std::vector<double>& k = curve.controls;
  for (std::size_t i = 1; i < k.size(); ++i)
    if (std::abs(k[i] - k[i - 1]) <= rounding) k[i] = k[i - 1];
  return IntrinsicSegment(form_of(curve, 0.0));
}

}  // namespace

Verdict verdict_of(const StandardCurve& curve) {
  const IntrinsicSegment segment = cleaned(curve);
  Verdict verdict{Trend::not_monotone, static_cast<int>(curvature_extrema(segment).at.size())};
  if (verdict.extrema == 0) {
    const std::vector<double>& k = segment.form().control_curvatures;
    const double rise = k.back() - k.front();
    verdict.trend = rise > 0.0 ? Trend::rising : rise < 0.0 ? Trend::falling : Trend::constant;
  }
  return verdict;
}

ControlRule rule_for(const StandardData& data, const BSplineBasis& basis, double p) {
  const int last = basis.size() - 1;
  ControlRule rule = interpolated(basis, data.start_curvature ? 1 : 0, data.end_curvature ? last - 1 : last, p);
  if (data.start_curvature) fix(rule, 0, *data.start_curvature);
  if (data.end_curvature) fix(rule, last, *data.end_curvature);
  return rule;
}

namespace {

constexpr double too_much_turning = 1e4;  ///< radians: rounding of angles spoils positions

double absolute_turning(const StandardCurve& curve) {
  const std::vector<double> integrals = basis_integrals(curve.basis);
  double sum = 0.0;
  for (std::size_t i = 0; i < integrals.size(); ++i) sum += integrals[i] * std::abs(curve.controls[i]);
  return curve.length * sum;
}

}  // namespace

HermiteFit judged(const StandardData& data, StandardCurve curve, int iterations, bool converged) {
  HermiteFit fit{Outcome::failed, "the solver left the range of numbers", std::nullopt, iterations, 0.0};
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::ranges::all_of(curve.controls, finite) || !(curve.length > 0.0) || !std::isfinite(curve.length)) return fit;
  if (const double turning = absolute_turning(curve); !(turning <= too_much_turning)) {
    fit.message = fmt::format("the curve turns by {:.3g} radians in all", turning);
    return fit;
  }
  fit.residual = gap(curve, data);
  fit.curve = std::move(curve);
  // What the rounding of the largest curvature does to angles and positions.
  const double accuracy = std::clamp(1e-14 * largest_control(*fit.curve), 1e-12, 1e-10);
  const bool met = converged && fit.residual <= accuracy;
  fit.outcome = met ? Outcome::converged : Outcome::not_converged;
  fit.message = met ? "" : fmt::format("the end is missed by {:.3g} chords", fit.residual);
  return fit;
}

namespace {

StandardCurve circular_arc(const StandardData& data, const Settings& settings) {
  const double curvature = 2.0 * std::sin(data.chord_angle);
  // An arc's length over its chord.
  const double length = data.chord_angle == 0.0 ? 1.0 : data.chord_angle / std::sin(data.chord_angle);
  return {settings.basis, std::vector<double>(static_cast<std::size_t>(settings.basis.size()), curvature), length};
}

HermiteFit solve_automatically(const StandardData& data, const Settings& settings) {
  const Viability v = viability(data);
  constexpr double rounding = 1e-12;
  if (v.only_circle() && std::max(std::abs(v.start_slack), std::abs(v.end_slack)) <= rounding) {
    const bool straight_back = std::abs(std::sin(data.chord_angle)) <= rounding && std::cos(data.chord_angle) < 0.0;
    if (straight_back)
      return {Outcome::unsupported_input,
              "no monotone curvature: a line that leaves straight away from the next point does not come back",
              std::nullopt, 0, 0.0};
    return judged(data, circular_arc(data, settings), 0, true);
  }
  if (!v.viable())
    return {Outcome::unsupported_input, "no monotone curvature: " + reason_not_viable(v), std::nullopt, 0, 0.0};
  MonotoneSolution solution = solve_monotone(data);
  return judged(data, std::move(solution.curve), solution.iterations, solution.converged);
}

/// With one curvature given the other one is free: if any makes the data viable, that with the nesting of the clothoid.
StandardData completed(StandardData data) {
  if (data.start_curvature.has_value() == data.end_curvature.has_value()) return data;
  const Solved clothoid = g1_clothoid(data);
  const StandardData linear{data.chord_angle, data.turning, clothoid.x, clothoid.y};
  const Viability wanted = viability(linear);
  const double sign = wanted.rising ? 1.0 : -1.0;
  const bool start_given = data.start_curvature.has_value();
  StandardData tried = linear;
  (start_given ? tried.start_curvature : tried.end_curvature) = start_given ? data.start_curvature : data.end_curvature;
  const Viability v = viability(tried);
  const double slack = start_given ? v.start_slack : v.end_slack;
  if (!clothoid.converged || v.only_circle() || !(slack > 0.0)) return data;
  const double other = wanted.nesting * v.least_product / slack;
  if (start_given)
    tried.end_curvature = 2.0 * std::sin(data.end_angle()) + sign * other;
  else
    tried.start_curvature = 2.0 * std::sin(data.chord_angle) - sign * other;
  return tried;
}

}  // namespace

HermiteFit solve(const StandardData& asked, const Settings& settings) {
  const StandardData data = settings.automatic ? completed(asked) : asked;
  const int given = (data.start_curvature ? 1 : 0) + (data.end_curvature ? 1 : 0);
  if (settings.automatic && given == 2) return solve_automatically(data, settings);
  if (settings.basis.size() < 2 + given)
    return {Outcome::unsupported_input,
            fmt::format("{} controls are too few for {} given curvatures; take at least {}", settings.basis.size(),
                        given, 2 + given),
            std::nullopt, 0, 0.0};
  const FixedKnots knots(settings.basis, rule_for(data, settings.basis, settings.p));
  const Solved solved = settings.method == Method::simplex ? solve_by_simplex(knots, data) : knots.solve(data);
  return judged(data, knots.curve(solved), solved.iterations, solved.converged);
}

}  // namespace kappabench::intrinsic
