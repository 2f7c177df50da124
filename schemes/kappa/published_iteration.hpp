#pragma once

#include <vector>

#include "schemes/kappa/system.hpp"

namespace kappabench::kappa {

/// Algorithm 1 of Miura 2022, step by step: its local phase (Eqs. (10) and (6) with the areas of the step before) and
/// its global phase (Eq. (11)). Also the rough start of the Newton iteration.
class PublishedIteration {
 public:
  explicit PublishedIteration(const System& system) : system_(&system) {}

  /// One pass of the loop. False if the linear system is singular; the state is then unchanged.
  [[nodiscard]] bool step(State& state);

  /// At most `count` passes; the number of those that worked.
  int steps(State& state, int count);

 private:
  const System* system_;
  Values values_;
  State next_;
  BlockTridiagonal<1> matrix_;
  std::vector<BlockRight<1, 2>> right_;
  BlockTridiagonalSolver<1, 2> solver_;
};

}  // namespace kappabench::kappa
