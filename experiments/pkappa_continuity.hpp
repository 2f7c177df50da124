#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Fig. 13: C1, G1, C2 and G2, on a drawing and on random curves.
[[nodiscard]] Experiment pkappa_continuity_experiment();

}  // namespace kappabench
