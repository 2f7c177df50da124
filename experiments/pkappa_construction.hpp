#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Figs. 6 to 8: which segments an insertion, the closing and a moved point change.
[[nodiscard]] Experiment pkappa_construction_experiment();

}  // namespace kappabench
