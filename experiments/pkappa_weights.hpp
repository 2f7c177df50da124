#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Fig. 10 and Table 1: eight pairs of weights, on a drawing, on random curves, perturbed and scaled.
[[nodiscard]] Experiment pkappa_weights_experiment();

}  // namespace kappabench
