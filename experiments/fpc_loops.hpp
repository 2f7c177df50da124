#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Fig. 2: two loops from typed points, and what other curves need for them.
[[nodiscard]] Experiment fpc_loops_experiment();

}  // namespace kappabench
