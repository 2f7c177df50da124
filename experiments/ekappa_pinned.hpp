#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// How often the joint slides onto an input point, so that |kappa| has no peak there, against a: over all drawings and
/// random families. Judges "extremum-at-points". How often fits converge, too.
[[nodiscard]] Experiment ekappa_pinned_experiment();

}  // namespace kappabench
