#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Figs. 1 and 8: typed drawings, and whether their joints are what they should be.
[[nodiscard]] Experiment fpc_gallery_experiment();

}  // namespace kappabench
