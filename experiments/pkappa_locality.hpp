#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang et al. 2024, Fig. 15 and Section 6.3: what moving one point changes, for every scheme.
[[nodiscard]] Experiment pkappa_locality_experiment();

}  // namespace kappabench
