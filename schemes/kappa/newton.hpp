#pragma once

#include <functional>
#include <utility>

#include "schemes/kappa/system.hpp"

namespace kappabench::kappa {

/// Damped Newton on the equations of a System: full steps, each point's part clipped, then halved until the sum of
/// squares decreases.
class Newton {
 public:
  explicit Newton(const System& system) : system_(&system) {}

  /// `observer` is called with the state after each step, for traces.
  void observe(std::function<void(const State&)> observer) { observer_ = std::move(observer); }

  struct Result {
    bool converged;
    int steps;
  };

  /// Improves `state` until the residual is below `tolerance`, at most `steps` times.
  Result run(State& state, const Setting& setting, int steps, double tolerance);

  /// The values at the state that `run` left.
  [[nodiscard]] const Values& values() const { return values_; }

 private:
  [[nodiscard]] bool step(State& state, const Setting& setting);

  const System* system_;
  std::function<void(const State&)> observer_;
  Values values_, trial_values_;
  State trial_;
  Block4 jacobian_;
  std::vector<Right4> right_;
  BlockTridiagonalSolver<4> solver_;
};

}  // namespace kappabench::kappa
