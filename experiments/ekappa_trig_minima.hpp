#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// How often the trigonometric curve passes a point at a minimum of |kappa|, against a. Judges
/// "trigonometric-local-maximum".
[[nodiscard]] Experiment ekappa_trig_minima_experiment();

}  // namespace kappabench
