#pragma once

#include "schemes/kappa/cascade.hpp"

namespace kappabench::kappa {

/// Solves a chain with the parameters t_i as unknowns of their own, in equations that are smooth in all of them:
///   b_0(t) X + b_1(t) e + b_2(t) Y = 0        the segment passes its point at t,
///   K(t) t (1 - t) + softness (1 - 2 t) nu |v|^2 = 0   |kappa| peaks there,
/// of which the second is the central path of the complementarity problem "K = 0 inside, K <= 0 at the start, K >= 0 at
/// the end", which is what peaking on the closed segment means. Where a segment is nearly straight, its peak depends
/// on its control points as 1 over the square of its turn: solved for t first (Form::direct), the equations are
/// singular there, these are not, and points run into the ends of their segments and out again on the way.
/// The softness falls from 1; on the way the exact problem is tried, with the points pinned that are at an end.
[[nodiscard]] Solution solve_by_peaks(const ChordChain& chain, const State& start, double softness, int sweeps);

}  // namespace kappabench::kappa
