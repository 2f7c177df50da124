#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Figs. 7 and 8: single G2 curves, by fixed knots and by the automatic family; near the border curvature
/// is like a step.
[[nodiscard]] Experiment intrinsic_g2_experiment();

}  // namespace kappabench
