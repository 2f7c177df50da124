#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Sects. 1 and 3: cusps, loops and inflections only where they are asked for.
[[nodiscard]] Experiment fpc_features_experiment();

}  // namespace kappabench
