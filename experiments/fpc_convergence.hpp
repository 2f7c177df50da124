#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Fig. 4: the published iteration, step by step.
[[nodiscard]] Experiment fpc_convergence_experiment();

}  // namespace kappabench
