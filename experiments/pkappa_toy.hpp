#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Fig. 5: one quintic segment through three points, its curvature and its parabola.
[[nodiscard]] Experiment pkappa_toy_experiment();

}  // namespace kappabench
