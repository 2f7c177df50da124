#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Section 5: fitting and drawing the bear with the three kinds of curves, timed.
[[nodiscard]] Experiment ekappa_timing_experiment();

}  // namespace kappabench
