#pragma once

#include "schemes/pkappa/chain.hpp"

namespace kappabench::pkappa {

/// What a finer rule finds in a result.
struct Verification {
  /// E_p of every segment agrees with that on the rule it was minimised with (a cusp or a tight loop between nodes
  /// would show), and no control polygon is much longer than the points demand.
  bool sound = false;
  double worst_parabola = 0.0;  ///< the largest E_p of a segment
};

template <Continuity K>
[[nodiscard]] Verification verify(const Chain& chain, const QuadratureRule& rule);

}  // namespace kappabench::pkappa
