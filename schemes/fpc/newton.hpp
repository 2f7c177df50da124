#pragma once

#include <functional>
#include <utility>

#include "schemes/fpc/system.hpp"

namespace kappabench::fpc {

/// Damped Newton on the equations of a System: each point's part of a step is clipped, then the step is halved until
/// the sum of squares decreases.
class Newton {
 public:
  explicit Newton(const System& system) : system_(&system) {}

  /// `observer` is called with the state after each step, for traces.
  void observe(std::function<void(const State&)> observer) { observer_ = std::move(observer); }

  struct Result {
    bool converged;
    int steps;
  };

  /// Improves `state` until no equation is off by more than `tolerance`, with at most `steps` steps.
  Result run(State& state, double softness, int steps, double tolerance);

  /// Full steps as long as they lower residual_of, at most `steps`; returns their number. The sum of squares is blind
  /// to relative errors in segments that are a millionth of their neighbours; this is not.
  int polish(State& state, double softness, int steps);

 private:
  [[nodiscard]] bool step(State& state, double softness);
  /// The full step from the state of `values_`, in `right_`.
  [[nodiscard]] bool solve(double softness);

  const System* system_;
  std::function<void(const State&)> observer_;
  Values values_, trial_values_;
  State trial_;
  Block3 matrix_;
  std::vector<Right3> right_;
  BlockTridiagonalSolver<3> solver_;
};

/// state + factor * step, a step in lengths, each segment's part of it shortened to `longest` sizes and units of log
/// weight.
void advance(const CubicChain& chain, const State& state, std::span<const Right3> step, double factor, double longest,
             State& to);

}  // namespace kappabench::fpc
