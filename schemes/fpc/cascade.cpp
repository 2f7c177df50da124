#include "schemes/fpc/cascade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "schemes/fpc/continuation.hpp"
#include "schemes/fpc/newton.hpp"

namespace kappabench::fpc {
namespace {

constexpr int first_sweeps = 3;
/// The part of the way to the weights that a sweep takes. At 1 alternating segments overshoot each other.
constexpr double sweep_damping = 0.7;
constexpr int exact_steps = 12;         ///< of Newton, from a state that should be near
constexpr double exact_target = 1e-14;  ///< what it aims at; rounding may stop it earlier
constexpr double worth_polishing = 0.1;
constexpr int polishing_steps = 5;

constexpr double full_step = 0.1;         ///< the factor by which softness falls when all is well
constexpr double shortest_step = 0.99;    ///< a factor so near to 1 means that the path is lost
constexpr double try_exact_at = 0.2;      ///< softness at which the exact problem is tried first
constexpr double later_step = 0.01;       ///< the same below `try_exact_at` squared, where little changes
constexpr double least_softness = 1e-36;  ///< a segment of length e has an area of about e^3
constexpr double path_tolerance = 1e-6;
constexpr int corrector_steps = 12;
constexpr long most_path_steps = 400, most_arc_steps = 5000;

/// Where the path begins: at softness 10 the problem is almost linear; other starts give other paths the chance.
constexpr std::array arc_starts{10.0, 1000.0, 0.1};

class Cascade {
 public:
  Cascade(const Chain& chain, bool trace) : chain_(chain), system_(chain), newton_(system_), tracing_(trace) {
    if (trace) newton_.observe([this](const State& state) { record(state); });
  }

  Solution solve(const State* near) {
    solution_.residual = std::numeric_limits<double>::infinity();
    try_all(near);
    solution_.iterations = static_cast<double>(solution_.effort.iterations());
    return std::move(solution_);
  }

 private:
  void try_all(const State* near) {
    if (near != nullptr && exact(*near)) return;
    if (State state; begin(state)) {
      ++solution_.effort.attempts;
      sweep(state);
      if (exact(state)) return;
    }
    ++solution_.effort.attempts;
    if (follow(arc_starts[0])) return;
    for (const double softness : arc_starts) {
      ++solution_.effort.attempts;
      if (follow_arc(softness)) return;
    }
  }

  [[nodiscard]] double residual(const State& state) const {
    return residual_of(chain_, state, system_.log_ratios(state));
  }

  void record(const State& state) {
    if (tracing_) solution_.trace.push_back(residual(state));
  }

  /// lambda = 1 everywhere, as Algorithm 1 begins.
  bool begin(State& state) {
    const std::vector<double> equal(chain_.joints(), 0.0);
    if (!system_.solve_joints(equal, state)) return false;
    system_.solve_weights(state);
    record(state);
    return true;
  }

  void sweep(State& state) {
    State next = state;
    for (int i = 0; i < first_sweeps; ++i) {
      if (!system_.solve_joints(system_.log_ratios(state), next)) return;
      system_.solve_weights(next);
      for (std::size_t k = 0; k < chain_.segments(); ++k)
        next.log_weight[k] = std::lerp(state.log_weight[k], next.log_weight[k], sweep_damping);
      std::swap(state, next);
      ++solution_.effort.sweeps;
      record(state);
    }
  }

  Newton::Result run_newton(State& state, double softness, int steps, double tolerance) {
    const Newton::Result result = newton_.run(state, softness, steps, tolerance);
    solution_.effort.newton += result.steps;
    return result;
  }

  /// Newton on the exact problem.
  bool exact(State state) {
    run_newton(state, 0.0, exact_steps, exact_target);
    return keep(std::move(state), 0.0);
  }

  /// Keeps the best state of all. True if it is a solution, if need be after polishing.
  bool keep(State state, double softness) {
    double reached = residual(state);
    if (reached > accuracy && reached < worth_polishing) {
      solution_.effort.newton += newton_.polish(state, softness, polishing_steps);
      reached = residual(state);
    }
    if (reached < solution_.residual) {
      solution_.residual = reached;
      solution_.state = std::move(state);
      solution_.converged = reached <= accuracy;
    }
    return solution_.converged;
  }

  /// The solution for a large softness: weights and ratios are constants, the joints a linear system away.
  bool soften(double softness, State& state) {
    state.log_weight.clear();
    for (const double size : chain_.size) state.log_weight.push_back(std::log(softness * size * size) / 3.0);
    ++solution_.effort.sweeps;
    if (!system_.solve_joints(system_.log_ratios(state), state)) return false;
    return run_newton(state, softness, 5 * corrector_steps, path_tolerance).converged;
  }

  /// Follows the solution as the softness goes to zero and tries the exact problem on the way.
  bool follow(double softness) {
    State good;
    if (!soften(softness, good)) return false;
    double reached = softness, factor = full_step;
    const long begun = solution_.effort.newton;
    while (solution_.effort.newton - begun < most_path_steps && factor < shortest_step && reached > least_softness) {
      State state = good;
      const double next = reached * factor;
      const Newton::Result result = run_newton(state, next, corrector_steps, path_tolerance);
      if (!result.converged) {
        factor = std::sqrt(factor);
        continue;
      }
      good = std::move(state);
      reached = next;
      if (reached <= try_exact_at && exact(good)) return true;
      if (result.steps <= 4)
        factor = std::max(reached < try_exact_at * try_exact_at ? later_step : full_step, factor * factor);
    }
    // A segment whose equation cannot hold for any area but zero shrinks as the softness does, to its point.
    if (reached > least_softness) return false;
    run_newton(good, reached, exact_steps, exact_target);
    return keep(std::move(good), reached);
  }

  bool follow_arc(double softness) {
    State state;
    if (!soften(softness, state)) return false;
    double exact_at = try_exact_at;
    solution_.effort.newton +=
        follow_path(system_, state, softness, most_arc_steps, [&](const State& at, double reached) {
          record(at);
          if (reached > exact_at) return false;
          exact_at = full_step * reached;
          return exact(at);
        });
    return solution_.converged;
  }

  const Chain& chain_;
  System system_;
  Newton newton_;
  Solution solution_;
  bool tracing_;
};

}  // namespace

Effort& Effort::operator+=(const Effort& other) {
  sweeps += other.sweeps;
  newton += other.newton;
  attempts += other.attempts;
  return *this;
}

Solution solve_chain(const Chain& chain, const State* near, bool trace) { return Cascade(chain, trace).solve(near); }

}  // namespace kappabench::fpc
