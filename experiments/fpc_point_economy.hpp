#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Fig. 9: twelve typed points against thirty-six plain ones.
[[nodiscard]] Experiment fpc_point_economy_experiment();

}  // namespace kappabench
