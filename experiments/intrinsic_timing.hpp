#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Table 1: time to solve a G1 condition and evaluate 500 points, by the published simplex and by
/// Newton's method.
[[nodiscard]] Experiment intrinsic_timing_experiment();

}  // namespace kappabench
