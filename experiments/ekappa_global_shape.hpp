#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Figs. 3, 8 and 9: one a for all points of a drawing, and what the curves keep of the kappa-curve.
[[nodiscard]] Experiment ekappa_global_shape_experiment();

}  // namespace kappabench
