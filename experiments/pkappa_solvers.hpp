#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// What minimises a window: energy, time and failures of the four optimisers.
[[nodiscard]] Experiment pkappa_solvers_experiment();

}  // namespace kappabench
