#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Fig. 3: G1 interpolation with different p, and with equal control curvatures at the ends. On random
/// conditions: is curvature monotone, and is there always a solution? The number of conditions can be set:
/// datasets = ["random-g1:n=100000"].
[[nodiscard]] Experiment intrinsic_g1_experiment();

}  // namespace kappabench
