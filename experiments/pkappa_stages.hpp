#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Fig. 9: the start, stage 1 and stage 2.
[[nodiscard]] Experiment pkappa_stages_experiment();

}  // namespace kappabench
