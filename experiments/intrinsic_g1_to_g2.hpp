#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Yoshida 2022, Fig. 10: chains of G1 segments, then with equal curvature where they meet. Takes drawings, whose
/// points may have tangents.
[[nodiscard]] Experiment intrinsic_g1_to_g2_experiment();

}  // namespace kappabench
