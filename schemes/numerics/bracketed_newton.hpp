#pragma once

#include <cmath>
#include <limits>

namespace kappabench {

/// A function value and its derivative.
struct ValueAndSlope {
  double value, slope;
};

/// Where bisection takes over from Newton.
enum class Bisect {
  where_newton_leaves,  ///< the bracket: fewest evaluations, for functions that are known to be tame
  where_newton_slows    ///< or does not halve its step, either
};

/// A root of a function that is not negative at `low` and not positive at `high`, to the last digits: Newton kept in a
/// shrinking bracket. `f(x)` returns a ValueAndSlope. Always returns a number in the bracket, after at most 200
/// evaluations, 100 where Newton is only kept inside.
///
/// A Newton step of two units in the last place of x ends it: x and the step are each rounded to half a unit, so that
/// no shorter step means anything. It has to be seen before the bracket is, whose one end is then x itself.
template <class Function>
[[nodiscard]] double falling_root_in(const Function& f, double low, double high, double guess,
                                     Bisect bisect = Bisect::where_newton_slows) {
  double x = guess > low && guess < high ? guess : 0.5 * (low + high);
  double step_before = high - low;
  constexpr double least_step = 2.0 * std::numeric_limits<double>::epsilon();
  const int most = bisect == Bisect::where_newton_slows ? 200 : 100;
  for (int i = 0; i < most; ++i) {
    const ValueAndSlope at = f(x);
    if (at.value == 0.0) return x;
    (at.value > 0.0 ? low : high) = x;
    double next = x - at.value / at.slope;
    if (std::abs(next - x) <= least_step * std::abs(x)) return x;
    const bool slow = bisect == Bisect::where_newton_slows && std::abs(next - x) > 0.5 * step_before;
    if (!(next > low && next < high) || slow) next = 0.5 * (low + high);
    const double step = std::abs(next - x);
    x = next;
    if (step <= least_step * std::abs(x)) break;
    step_before = step;
  }
  return x;
}

}  // namespace kappabench
