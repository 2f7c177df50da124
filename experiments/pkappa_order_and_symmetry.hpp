#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Section 7: reversed and symmetric input, window by window and all at once.
[[nodiscard]] Experiment pkappa_order_and_symmetry_experiment();

}  // namespace kappabench
