#include "schemes/kappa/cascade.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "schemes/kappa/continuation.hpp"
#include "schemes/kappa/peak_path.hpp"
#include "schemes/kappa/pins.hpp"

namespace kappabench::kappa {
namespace {

/// One way to a solution: a rough start, and how closely to follow which softened equations.
struct Attempt {
  int sweeps;            ///< of the published iteration, from the start
  double softness;       ///< to begin with
  Form form;             ///< of the softened equations
  double tolerance;      ///< to which each softened problem is solved
  bool relative;         ///< the tolerance is relative to the softness
  long most_iterations;  ///< before giving up
};

constexpr std::array cubic_attempts{
    Attempt{3, 1.0, Form::direct, 1e-2, false, 150}, Attempt{3, 1.0, Form::direct, 1e-3, false, 1000},
    Attempt{3, 1.0, Form::divided, 0.1, true, 1000}, Attempt{0, 3.0, Form::direct, 1e-4, false, 1000},
    Attempt{40, 0.3, Form::divided, 0.1, true, 1000}};
/// |kappa| of a trigonometric segment may have several peaks, between which the direct form jumps.
constexpr std::array trigonometric_attempts{
    Attempt{3, 0.3, Form::divided, 0.1, true, 60}, Attempt{3, 1.0, Form::divided, 0.1, true, 200},
    Attempt{40, 0.3, Form::divided, 0.1, true, 200}, Attempt{3, 1.0, Form::direct, 1e-3, false, 300}};

/// Attempts by arc length: softness of peaks to begin with, that of areas relative to it, and whether to set out
/// towards less or more softness. A branch that begins at a fold is left by going up first.
struct FoldAttempt {
  int sweeps;
  double softness, area_share;
  bool down;
};

constexpr std::array fold_attempts{FoldAttempt{3, 1.0, 1.0, true},   FoldAttempt{3, 1.0, 1.0, false},
                                   FoldAttempt{3, 1.0, 0.03, true},  FoldAttempt{3, 1.0, 0.03, false},
                                   FoldAttempt{3, 30.0, 1.0, true},  FoldAttempt{3, 0.1, 10.0, true},
                                   FoldAttempt{0, 10.0, 1e-3, true}, FoldAttempt{40, 1.0, 0.3, true}};

/// Attempts with the peaks' parameters as unknowns (peak_path.hpp).
struct PeakAttempt {
  int sweeps;
  double softness;
};

constexpr std::array peak_attempts{PeakAttempt{3, 1.0}, PeakAttempt{0, 30.0}, PeakAttempt{40, 0.1}};

constexpr double full_step = 0.1;         ///< the factor by which softness falls when all is well
constexpr double shortest_step = 0.99;    ///< a factor so near to 1 means that the path has ended
constexpr double try_exact_at = 0.01;     ///< softness at which the exact problem is tried first
constexpr double least_softness = 1e-11;  ///< where a path that found nothing ends
constexpr double most_softness = 300.0;
constexpr int corrector_steps = 12;
constexpr long most_fold_steps = 3000;
constexpr int pin_rounds = 4;

class Cascade {
 public:
  Cascade(const ChordChain& chain, bool trace) : chain_(chain), system_(chain), sweeps_(system_), newton_(system_) {
    if (trace) newton_.observe([this](const State& state) { record(state); });
    tracing_ = trace;
  }

  Solution solve(const State& start, const Setting* near, Attempts attempts) {
    try_all(start, near, attempts);
    solution_.iterations = static_cast<double>(solution_.effort.iterations());
    return std::move(solution_);
  }

 private:
  void try_all(const State& start, const Setting* near, Attempts attempts) {
    solution_.state = start;
    solution_.setting = uniform_setting(chain_, Form::divided);
    solution_.residual = residual_of(system_, start, values_);
    record(start);
    if (near != nullptr && exact(start, *near, false)) return;
    if (attempts == Attempts::near) return;
    const std::span<const Attempt> list = chain_.basis == BasisKind::cubic
                                              ? std::span<const Attempt>(cubic_attempts)
                                              : std::span<const Attempt>(trigonometric_attempts);
    const std::size_t usual = chain_.basis == BasisKind::cubic ? 1 : 2;
    for (const Attempt& attempt : list.first(usual)) {
      ++solution_.effort.attempts;
      if (follow(attempt, start)) return;
    }
    for (const PeakAttempt& attempt : peak_attempts) {
      ++solution_.effort.attempts;
      if (follow_peaks(attempt, start)) return;
      if (attempts != Attempts::all) return;
    }
    for (const Attempt& attempt : list.subspan(usual)) {
      ++solution_.effort.attempts;
      if (follow(attempt, start)) return;
    }
    for (const FoldAttempt& attempt : fold_attempts) {
      ++solution_.effort.attempts;
      if (follow_round_folds(attempt, start)) return;
    }
  }

  void record(const State& state) {
    if (tracing_) solution_.trace.push_back(residual_of(system_, state, values_));
  }

  State swept(const State& start, int count) {
    State state = start;
    for (int i = 0; i < count && sweeps_.step(state); ++i) {
      ++solution_.effort.sweeps;
      record(state);
    }
    return state;
  }

  /// Follows the solution of the softened problem as the softness goes to zero, and tries the exact problem on the
  /// way. True if that was solved.
  bool follow(const Attempt& attempt, const State& start) {
    const long begun = solution_.effort.iterations();
    State good = swept(start, attempt.sweeps);
    Setting soft = uniform_setting(chain_, attempt.form);
    double reached = 0.0, next = attempt.softness, factor = full_step, exact_at = try_exact_at;
    while (solution_.effort.iterations() - begun < attempt.most_iterations) {
      soft.softness = next;
      const double tolerance = attempt.relative ? std::max(accuracy, attempt.tolerance * next) : attempt.tolerance;
      State state = good;
      const Newton::Result result = run_newton(state, soft, corrector_steps, tolerance);
      if (result.converged) {
        good = std::move(state);
        reached = next;
        if (reached <= exact_at) {
          const bool arrived = reached < least_softness;
          if (finish(good, newton_.values(), arrived)) return true;
          if (arrived) return false;
          exact_at = 0.1 * reached;
        }
        if (result.steps <= 4) factor = std::max(full_step, factor * factor);
        next = reached * factor;
      } else if (reached == 0.0) {
        next *= 4.0;
        if (next > most_softness) return false;
      } else {
        factor = std::sqrt(factor);
        next = reached * factor;
        if (factor > shortest_step) {
          soft.softness = reached;
          system_.evaluate(good, soft, values_);
          return finish(good, values_, true);
        }
      }
    }
    return false;
  }

  /// The same along the path's arc length, which may take it back to more softness for a while.
  bool follow_round_folds(const FoldAttempt& attempt, const State& start) {
    State state = swept(start, attempt.sweeps);
    Setting soft = uniform_setting(chain_, Form::divided);
    soft.softness = attempt.softness;
    soft.area_share = attempt.area_share;
    if (!run_newton(state, soft, 4 * corrector_steps, 1e-6).converged) return false;
    bool solved = false;
    double exact_at = try_exact_at;
    solution_.effort.newton += follow_path(system_, state, soft, attempt.down, most_fold_steps,
                                           [&](const State& at, const Values& values, double reached) {
                                             record(at);
                                             if (reached > exact_at) return false;
                                             exact_at = 0.1 * reached;
                                             return solved = finish(at, values, false);
                                           });
    return solved;
  }

  bool follow_peaks(const PeakAttempt& attempt, const State& start) {
    Solution found = solve_by_peaks(chain_, start, attempt.softness, attempt.sweeps);
    solution_.effort += found.effort;
    if (!found.converged && !(found.residual < solution_.residual)) return false;
    solution_.state = std::move(found.state);
    solution_.setting = std::move(found.setting);
    solution_.residual = found.residual;
    solution_.converged = found.converged;
    record(solution_.state);
    return solution_.converged;
  }

  /// Solves the exact problem from a nearby softened one, correcting the set of pinned points. Where the path has
  /// ended, points that cannot be solved inside their segments are pinned one by one.
  bool finish(const State& near, const Values& near_values, bool path_ended) {
    return exact(near, guess_pins(chain_, near, near_values), path_ended);
  }

  bool exact(State state, Setting setting, bool path_ended) {
    const std::size_t rounds = path_ended ? pin_rounds + chain_.segments() : pin_rounds;
    for (std::size_t round = 0; round < rounds; ++round) {
      run_newton(state, setting, corrector_steps, 0.1 * accuracy);
      const Values& values = newton_.values();
      if (values.residual <= accuracy) {
        if (correct_pins(chain_, state, values, setting) > 0) continue;
        keep(state, setting, true);
        return true;
      }
      if (!path_ended || !pin_worst(chain_, state, values, setting)) break;
    }
    keep(state, setting, false);
    return false;
  }

  /// Remembers a solution, or the best of what is not one.
  void keep(const State& state, const Setting& setting, bool converged) {
    const double residual = residual_of(system_, state, values_);
    if (!converged && !(residual < solution_.residual)) return;
    solution_.state = state;
    solution_.setting = setting;
    solution_.residual = residual;
    solution_.converged = converged;
  }

  Newton::Result run_newton(State& state, const Setting& setting, int steps, double tolerance) {
    const Newton::Result result = newton_.run(state, setting, steps, tolerance);
    solution_.effort.newton += result.steps;
    return result;
  }

  const ChordChain& chain_;
  System system_;
  PublishedIteration sweeps_;
  Newton newton_;
  Values values_;
  bool tracing_ = false;
  Solution solution_;
};

}  // namespace

Effort& Effort::operator+=(const Effort& other) {
  sweeps += other.sweeps;
  newton += other.newton;
  attempts += other.attempts;
  return *this;
}

Solution solve_chain(const ChordChain& chain, const State& start, const Setting* near, Attempts attempts, bool trace) {
  return Cascade(chain, trace).solve(start, near, attempts);
}

}  // namespace kappabench::kappa
