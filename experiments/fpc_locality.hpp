#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Fig. 10: how far moving a point is felt.
[[nodiscard]] Experiment fpc_locality_experiment();

}  // namespace kappabench
