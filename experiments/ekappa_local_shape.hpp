#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Figs. 5 and 6: another a at some of the points, and how far its influence reaches.
[[nodiscard]] Experiment ekappa_local_shape_experiment();

}  // namespace kappabench
