#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace kappabench {

/// Three equations and their derivatives at some values of the unknowns.
struct ThreeEquations {
  Eigen::Vector3d value;
  Eigen::Matrix3d jacobian;
};

struct NewtonResult {
  Eigen::Vector3d x;
  double residual;  ///< largest equation at x
  int iterations;
  bool converged;
};

/// Newton's method on three equations, no unknown changing by more than its entry of `largest_step` at a time, and each
/// step halved until the residual falls. Converged below `tolerance`, which the caller sets to what rounding allows.
template <class F>
[[nodiscard]] NewtonResult damped_newton(const F& equations, const Eigen::Vector3d& start,
                                         const Eigen::Vector3d& largest_step, double tolerance,
                                         int most_iterations = 40) {
  const auto size = [](const ThreeEquations& e) {
    const double r = e.value.lpNorm<Eigen::Infinity>();
    return std::isfinite(r) ? r : HUGE_VAL;
  };
  Eigen::Vector3d x = start;
  ThreeEquations at = equations(x);
  NewtonResult result{x, size(at), 0, false};
  while (result.residual > tolerance && result.iterations < most_iterations && std::isfinite(result.residual)) {
    Eigen::Vector3d step = -at.jacobian.partialPivLu().solve(at.value);
    if (!step.allFinite()) break;
    const double excess = step.cwiseAbs().cwiseQuotient(largest_step).maxCoeff();
    if (excess > 1.0) step /= excess;
    bool fell = false;
    for (int halvings = 0; halvings < 12 && !fell; ++halvings, step *= 0.5) {
      const Eigen::Vector3d next = x + step;
      ThreeEquations tried = equations(next);
      if (size(tried) >= result.residual) continue;
      fell = true;
      x = next;
      at = tried;
    }
    ++result.iterations;
    if (!fell) break;
    result.x = x;
    result.residual = size(at);
  }
  result.converged = result.residual <= tolerance;
  return result;
}

/// Follows the solution of a problem that depends on s from s = 0, where `x` solves it, to s = 1. `solve_at(s, guess)`
/// returns a NewtonResult. Secant predictor; the step doubles after a success and shrinks to 0.35 of itself after a
/// failure. The result's iterations are those of all steps; not converged if the step falls below `least_step` or after
/// 200 steps.
template <class Solve>
[[nodiscard]] NewtonResult follow_solution(const Solve& solve_at, const Eigen::Vector3d& x, double first_step = 1.0,
                                           double least_step = 1e-4) {
  constexpr int most_tries = 200;
  struct Known {
    double s;
    Eigen::Vector3d x;
  };
  Known last{0.0, x};
  std::optional<Known> before;
  NewtonResult result{x, 0.0, 0, false};
  double step = first_step;
  for (int tries = 0; last.s < 1.0; ++tries) {
    if (tries == most_tries) return result;
    const double s = std::min(1.0, last.s + step);
    Eigen::Vector3d guess = last.x;
    if (before) guess += (last.x - before->x) * ((s - last.s) / (last.s - before->s));
    const NewtonResult at = solve_at(s, guess);
    result.iterations += at.iterations;
    if (at.converged) {
      before = last;
      last = {s, at.x};
      result.x = at.x;
      result.residual = at.residual;
      step *= 2.0;
    } else if ((step *= 0.35) < least_step) {
      return result;
    }
  }
  result.converged = true;
  return result;
}

}  // namespace kappabench
