#include "schemes/euler_spiral/solution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "schemes/curve/joint.hpp"
#include "schemes/euler_spiral/continuation.hpp"

namespace kappabench::euler_spiral {

namespace {

using std::numbers::pi;

double along(const Span& span) { return span.clothoid.along; }

/// Newton's method alone where it starts near enough; `directly` tries that.
Solution with_turns(const Polygon& polygon, bool directly) {
  System system(polygon);
  Reached reached{.at = {.headings = {}, .residual = HUGE_VAL, .iterations = 0}, .bend = 1.0};
  if (directly) reached.at = newton(system, circle_headings(polygon), 1.0);
  const bool continued = !reached.at.solved();
  if (continued) {
    const int iterations = reached.at.iterations;
    reached = from_small_turns(system, polygon.points());
    reached.at.iterations += iterations;
  }
  (void)system.evaluate(reached.at.headings, reached.bend);
  return {system.spans(), reached.at.residual, reached.bend, reached.at.iterations, continued, 0};
}

/// The sharper of the turns at both ends of a span, of those that are sharp and still as `given`.
std::optional<std::size_t> sharp_turn(const std::vector<double>& turns, const std::vector<double>& given,
                                      std::size_t span) {
  constexpr double sharp = 0.75 * pi;
  std::optional<std::size_t> sharpest;
  for (const std::size_t k : {span, (span + 1) % turns.size()})
    if (turns[k] == given[k] && std::abs(turns[k]) > (sharpest ? std::abs(turns[*sharpest]) : sharp)) sharpest = k;
  return sharpest;
}

}  // namespace

std::size_t Solution::longest_span() const {
  return static_cast<std::size_t>(std::ranges::min_element(spans, {}, along) - spans.begin());
}

bool Solution::runs_away() const { return along(spans[longest_span()]) < 0.01; }

bool Solution::is_spline() const { return residual <= solver_accuracy && !runs_away(); }

Solution solution_of(const Polygon& polygon) {
  constexpr int most_swaps = 8;
  const Solution as_given = with_turns(polygon, true);
  Polygon swapped = polygon;
  Solution tried = as_given;
  for (int swaps = 1; swaps <= most_swaps && !tried.is_spline(); ++swaps) {
    const auto k = sharp_turn(swapped.turns, polygon.turns, tried.longest_span());
    if (!k) break;
    swapped.turns[*k] -= std::copysign(2.0 * pi, swapped.turns[*k]);
    const int iterations = tried.iterations;
    tried = with_turns(swapped, false);
    tried.iterations += iterations;
    tried.other_side = swaps;
  }
  return tried.is_spline() ? tried : as_given;
}

}  // namespace kappabench::euler_spiral
