#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Figs. 11 and 12: the cubic Bernstein against the quadratic trigonometric basis.
[[nodiscard]] Experiment ekappa_bases_experiment();

}  // namespace kappabench
