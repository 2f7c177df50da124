#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Wang 2024, Figs. 11 and 12 and Table 2: six cartoons and the profile of a car.
[[nodiscard]] Experiment pkappa_gallery_experiment();

}  // namespace kappabench
