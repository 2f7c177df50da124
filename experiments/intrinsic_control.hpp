#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Fig. 9: control curvatures are moved, the Hermite data stay; and how far they can be moved. The
/// number of curves for that can be set: datasets = ["random-g1:n=12"].
[[nodiscard]] Experiment intrinsic_control_experiment();

}  // namespace kappabench
