#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Fig. 7: at an inflection the curve is only G1, and the jump of curvature shrinks as a grows.
[[nodiscard]] Experiment ekappa_inflection_experiment();

}  // namespace kappabench
