#include "schemes/kappa/family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "schemes/kappa/assemble.hpp"
#include "schemes/kappa/cascade.hpp"
#include "schemes/kappa/published_iteration.hpp"
#include "schemes/kappa/shrunken.hpp"
#include "schemes/kappa/windows.hpp"
#include "schemes/segments/open_curve.hpp"

namespace kappabench::kappa {

std::vector<ParameterSpec> iteration_parameters() {
  return {{.name = "iteration",
           .default_value = std::string("newton"),
           .help = "how the equations are solved: damped Newton with fallbacks, or the papers' Algorithm 1",
           .choices = {"newton", "published"}},
          {.name = "max_iterations",
           .default_value = 50L,
           .help = "the most steps of iteration=published (newton has its own bounds)",
           .least = 1,
           .most = 1000000}};
}

SchemeTraits family_traits() {
  return {.fewest_open_points = 2,
          .continuity = Continuity::g2,
          .continuity_exceptions =
              "where the curvature changes sign (S-joints): G1 with equal |curvature|; where a segment has shrunk to "
              "its point, or where the polygon is straight to 1e-10: G1, or G0 if the path turns back there"};
}

Iteration iteration_of(const Parameters& parameters) {
  return {.published = parameters.text("iteration") == "published",
          .max_iterations = static_cast<int>(parameters.integer("max_iterations"))};
}

Sharpness sharpness_of(const Input& input, double global, const ParameterSpec& spec) {
  Sharpness result{std::vector<double>(input.points.size(), global), {}};
  for (int i = 0; i < input.size(); ++i) {
    const std::optional<double> own = input.options_of(i).a;
    if (!own) continue;
    try {
      validate(spec, ParameterValue(*own));
    } catch (const std::invalid_argument& error) {
      result.problem = fmt::format("point {}: {}", i, error.what());
      return result;
    }
    result.values[static_cast<std::size_t>(i)] = *own;
  }
  return result;
}

Fit refusal(const Input& input, std::string why) {
  return {input, std::nullopt, {.outcome = Outcome::unsupported_input, .message = std::move(why)}};
}

namespace {

/// Algorithm 1 of Miura 2022 until the residual is small or the steps are used up.
Solution iterate_published(const ChordChain& chain, int most) {
  const System system(chain);
  PublishedIteration iteration(system);
  Values values;
  Solution solution{.state = initial_state(chain), .setting = uniform_setting(chain, Form::divided)};
  for (;;) {
    solution.residual = residual_of(system, solution.state, values);
    solution.trace.push_back(solution.residual);
    solution.converged = solution.residual <= accuracy;
    if (solution.converged || solution.effort.sweeps == most || !iteration.step(solution.state)) break;
    ++solution.effort.sweeps;
  }
  solution.iterations = static_cast<double>(solution.effort.sweeps);
  for (std::size_t i = 1; i <= chain.segments(); ++i)
    solution.setting.form[i] = nearest_form(system, solution.state, values, i);
  return solution;
}

Solution solve_as(const ChordChain& chain, Attempts attempts) {
  return chain.segments() > longest_whole_chain ? solve_in_windows(chain)
                                                : solve_chain(chain, initial_state(chain), nullptr, attempts, true);
}

Solution solve_all_ways(const ChordChain& chain) {
  Solution solution = solve_as(chain, Attempts::all);
  if (!solution.converged && chain.segments() >= least_repaired && chain.segments() <= longest_whole_chain)
    solution = repair_in_windows(chain, std::move(solution));
  return solution;
}

/// Along straight runs between arcs a quadratic's curvature is constant to the square of its turn: its peak is
/// anywhere, and the equations are singular to rounding. With areas that count as none from `coarse` on they are not.
constexpr double coarse = 1e-4;
/// Longer chains take that for the solution before the more costly attempts.
constexpr std::size_t longest_tried_on = 64;

/// Whether two points in a row lie straight between their neighbours, as coarsely.
bool has_straight_run(const ChordChain& chain) {
  bool before = false;
  for (std::size_t i = 1; i <= chain.segments(); ++i) {
    const Vec2 &to = chain.chord[i - 1], &from = chain.chord[i];
    const bool straight = to.dot(from) > 0.0 && std::abs(cross(to, from)) <= coarse * to.norm() * from.norm();
    if (straight && before) return true;
    before = straight;
  }
  return false;
}

/// Sets the least area of the chain to that of the solution.
Solution solve_by_newton(ChordChain& chain, double rounding) {
  Effort effort;
  double iterations = 0.0;
  const auto counted = [&](Solution solution) {
    effort += solution.effort;
    iterations += solution.iterations;
    return solution;
  };
  Solution solution;
  const bool bent = !has_straight_run(chain), in_windows = chain.segments() > longest_whole_chain;
  if (bent) solution = counted(solve_as(chain, Attempts::usual));
  if (!solution.converged) {
    ChordChain straightened = chain;
    straightened.least_area = coarse;
    Solution near = counted(solve_as(straightened, Attempts::usual));
    if (near.converged) solution = counted(solve_chain(chain, near.state, &near.setting, Attempts::near, true));
    const bool all_tried = bent && in_windows;  // windows know but one way
    if (!solution.converged && !all_tried && (!near.converged || chain.segments() <= longest_tried_on))
      solution = counted(solve_all_ways(chain));
    if (!solution.converged && near.converged) {
      chain.least_area = coarse;
      solution = std::move(near);
    }
  }
  solution.effort = effort;
  solution.iterations = iterations;
  shrink_at_inflections(chain, rounding, solution);
  return solution;
}

/// Points whose area counts as none, for a reason other than rounding.
long straightened_points(const ChordChain& chain, const State& state) {
  if (chain.least_area == ChordChain{}.least_area) return 0;
  long count = 0;
  for (std::size_t i = 1; i <= chain.segments(); ++i) count += is_straight(chain, polygon_legs(chain, state, i), i);
  return count;
}

}  // namespace

Fit fit_family(const Input& input, SegmentKind kind, std::span<const double> a, const Iteration& iteration) {
  if (const Line line = line_of(input.points, input.closed); line.straight) {
    if (!line.in_order)
      return refusal(input,
                     "the points lie on one line and turn back on it; a curve of this family would have cusps there");
    return {input,
            straight_line(input.points),
            {.outcome = Outcome::converged,
             .message = "the points lie on one line: the curve is that line",
             .trace = {0.0}}};
  }
  const BasisKind basis = kind == SegmentKind::trigonometric ? BasisKind::trigonometric : BasisKind::cubic;
  ChordChain chain = make_chain(input.points, a, input.closed, basis);
  const double rounding = std::numeric_limits<double>::epsilon() * largest_coordinate(input);
  const Solution solution =
      iteration.published ? iterate_published(chain, iteration.max_iterations) : solve_by_newton(chain, rounding);

  Fit fit{.input = input, .curve = std::nullopt, .report = {}};
  Report& report = fit.report;
  report.iterations = static_cast<int>(std::lround(solution.iterations));
  report.residual = solution.residual;
  report.trace = solution.trace;
  report.outcome = solution.converged ? Outcome::converged : Outcome::not_converged;
  if (!std::isfinite(solution.residual)) {
    report.outcome = Outcome::failed;
    report.message = "the iteration left the range of numbers";
    return fit;
  }
  if (!solution.converged)
    report.message = fmt::format("not solved: the residual is {:.2g}, {:.0e} is asked for", report.residual, accuracy);
  const long straightened = straightened_points(chain, solution.state);
  if (solution.converged && straightened > 0)
    report.message = fmt::format("on nearly straight runs {} segments have no curvature of their own", straightened);
  Assembled assembled = assemble(input, kind, chain, solution.state, solution.setting);
  fit.curve = std::move(assembled.curve);
  report.counters = std::move(assembled.counters);
  report.counters["sweeps"] = solution.effort.sweeps;
  report.counters["newton"] = solution.effort.newton;
  report.counters["straightened"] = straightened;
  if (!iteration.published) report.counters["attempts"] = solution.effort.attempts;
  return fit;
}

}  // namespace kappabench::kappa
