#pragma once

#include "schemes/kappa/cascade.hpp"

namespace kappabench::kappa {

/// Lets segments shrink to their points where that is the solution: T_i = 0, an inflection at the point (or a path that
/// turns straight back there). Then both joints of the segment are the point, the chain falls into parts that end there
/// like open curves, and c_{i-1}, p_i and c_{i+1} are on one line. Newton gets there only slowly, since T_i is kept as
/// a logarithm, and stops at a segment of 1e-11 to 1e-6 chords whose stored control points have no curvature left.
///
/// Tried for each segment that is tiny between nearly straight neighbours; kept if the parts are solved and the line is
/// straight to the accuracy of solutions, or if the tiny segment's curvature is lost in rounding in any case.
/// `rounding` is how far control points are moved when they are stored, a length. Improves or keeps the solution.
void shrink_at_inflections(const ChordChain& chain, double rounding, Solution& solution);

}  // namespace kappabench::kappa
