#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Fig. 5: alpha and beta control the size of a loop.
[[nodiscard]] Experiment fpc_loop_size_experiment();

}  // namespace kappabench
