#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Figs. 5 and 6: for which end curvatures is there a monotone curve? Eq. (12) against what is found, the
/// fixed knots of Fig. 6 against the automatic family, and random G2 data of many kinds. Numbers can be set:
/// datasets = ["grid:n=100", "random-g2:n=20000", "infeasible:n=400", "spirals:n=5000"] (points along a side of every
/// grid; data of each kind; data outside the region; random curves whose ends must be inside).
[[nodiscard]] Experiment intrinsic_viable_region_experiment();

}  // namespace kappabench
