#pragma once

#include "schemes/intrinsic/fixed_knots.hpp"

namespace kappabench::intrinsic {

/// The published solver, for comparison: downhill simplex (Nelder and Mead, as NLopt has it) on the distance of the end
/// from where it should be (chords), over the rule's two unknowns, with the length from Yoshida 2022, Eq. (8). That is
/// 0 / 0 for data that do not turn, and negative for controls that turn the wrong way: such data are not converged.
///
/// Starts at the linearised solution with a simplex of a tenth of its size, and stops at `tolerance` chords or after
/// 2000 evaluations, which are counted as iterations.
[[nodiscard]] Solved solve_by_simplex(const FixedKnots& knots, const StandardData& data, double tolerance = 1e-12);

}  // namespace kappabench::intrinsic
