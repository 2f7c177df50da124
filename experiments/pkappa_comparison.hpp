#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang et al. 2024, Fig. 14 and Section 6.3: four inputs, every scheme, and what the paper marks by hand, found.
[[nodiscard]] Experiment pkappa_comparison_experiment();

}  // namespace kappabench
