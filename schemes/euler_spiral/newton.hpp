#pragma once

#include "schemes/euler_spiral/system.hpp"

namespace kappabench::euler_spiral {

/// Where an iteration ended.
struct Found {
  Headings headings;
  double residual;  ///< the largest equation there; infinite if the start has no clothoids
  int iterations;   ///< linear solves

  /// To solver_accuracy: a jump of curvature of that part of 1 / shorter chord.
  [[nodiscard]] bool solved() const;
};

/// Newton's method on the equations for this `bend`, each step shortened until the sum of squares falls, to where
/// rounding ends it.
[[nodiscard]] Found newton(System& system, Headings headings, double bend);

}  // namespace kappabench::euler_spiral
