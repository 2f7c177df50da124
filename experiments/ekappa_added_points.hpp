#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Fig. 2: two added points make a curvature peak of the kappa-curve larger or smaller.
[[nodiscard]] Experiment ekappa_added_points_experiment();

}  // namespace kappabench
