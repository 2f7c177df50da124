#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// The published iteration after 50 and after 2000 steps against the Newton cascade, on every drawing: solved or not,
/// what residual and what curvature jump is left, convergence traces.
[[nodiscard]] Experiment ekappa_iterations_experiment();

}  // namespace kappabench
