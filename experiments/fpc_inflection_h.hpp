#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Chen 2019, Fig. 6: what h does at an inflection, and where it is singular.
[[nodiscard]] Experiment fpc_inflection_h_experiment();

}  // namespace kappabench
