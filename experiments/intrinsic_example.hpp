#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Fig. 1: a cubic B-spline curvature function, its Bezier form, the curve; Eqs. (5) and (7) against
/// quadrature.
[[nodiscard]] Experiment intrinsic_example_experiment();

}  // namespace kappabench
