#include "schemes/euler_spiral/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "schemes/numerics/arc_length_path.hpp"

namespace kappabench::euler_spiral {

namespace {

/// The equations as ArcLengthPath wants them: its softness is 1 / bend.
struct PathProblem {
  using State = Headings;
  using Step = std::vector<double>;

  System& system;

  double evaluate(const State& state, double softness) {
    return system.evaluate(state, 1.0 / softness) ? system.residual() : std::numeric_limits<double>::infinity();
  }
  bool solve(const State&, double softness, Step& newton_step, Step& response) {
    if (!system.solve(newton_step, response)) return false;
    for (double& r : response) r *= -1.0 / softness;  // d bend = -bend d log softness
    return true;
  }
  [[nodiscard]] static double dot(const Step& a, const Step& b, double start) {
    for (std::size_t k = 0; k < a.size(); ++k) start += a[k] * b[k];
    return start;
  }
  static void advance(const State& from, const Step& step, double factor, State& to) {
    to.resize(from.size());
    for (std::size_t k = 0; k < from.size(); ++k) to[k] = from[k] + factor * step[k];
  }
};

struct Known {
  Headings headings;
  double softness;
};

/// Between two points of the path, where the turns are whole.
Headings at_whole_turns(const Known& before, const Known& after) {
  const double part = std::log(before.softness) / std::log(before.softness / after.softness);
  Headings headings = before.headings;
  for (std::size_t k = 0; k < headings.size(); ++k) headings[k] = std::lerp(headings[k], after.headings[k], part);
  return headings;
}

}  // namespace

Reached from_small_turns(System& system, std::size_t points) {
  constexpr double first_softness = 20.0, least_along = 1e-3;
  constexpr long most_solves = 1000;
  constexpr PathLimits limits{
      .least_softness = 0.5, .most_softness = 2.0 * first_softness, .longest_in_log = 0.3, .shortest_length = 1e-4};
  Found start = newton(system, Headings(points, 0.0), 1.0 / first_softness);
  if (!start.solved()) return {std::move(start), 1.0 / first_softness};
  Known last{start.headings, first_softness}, before = last;
  PathProblem problem{system};
  ArcLengthPath<PathProblem> path(problem, limits);
  start.iterations += static_cast<int>(path.follow(
      std::move(start.headings), first_softness, true, most_solves, [&](const Headings& at, double softness) {
        before = std::exchange(last, {at, softness});
        const auto runs_away = [](const Span& span) { return span.clothoid.along < least_along; };
        return softness <= 1.0 || std::ranges::any_of(system.spans(), runs_away);
      }));
  if (last.softness > 1.0)
    return {{std::move(last.headings), std::numeric_limits<double>::infinity(), start.iterations}, 1.0 / last.softness};
  Found end = newton(system, at_whole_turns(before, last), 1.0);
  end.iterations += start.iterations;
  return {std::move(end), 1.0};
}

}  // namespace kappabench::euler_spiral
