#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Every scheme on closed random stars of growing size: time of a fit, time of an evaluated jet, memory, and the
/// exponents of growth. Sizes beyond the default ones come from a plan (experiments/plans/scaling-full.toml).
[[nodiscard]] Experiment scaling_experiment();

}  // namespace kappabench
