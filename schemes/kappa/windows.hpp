#pragma once

#include "schemes/kappa/cascade.hpp"

namespace kappabench::kappa {

/// Chains longer than this are solved in windows.
inline constexpr std::size_t longest_whole_chain = 256;

/// Solves a long chain in overlapping windows, again and again where equations do not hold yet, and finishes with
/// Newton on the whole chain where that is needed. The influence of a point decays exponentially along the chain,
/// so a few passes suffice, and one bad spot costs no more than its window: time and memory are linear in the
/// number of points. The order of windows is fixed, so the result is reproducible. The trace has one entry a pass.
[[nodiscard]] Solution solve_in_windows(const ChordChain& chain);

/// Solves the spots of a chain that are open in `unsolved` in windows of their own, narrow and wide, from where they
/// are and from zeros. What it was given if that does not solve the chain.
[[nodiscard]] Solution repair_in_windows(const ChordChain& chain, Solution unsolved);

/// The fewest segments that are repaired in windows.
inline constexpr std::size_t least_repaired = 8;

}  // namespace kappabench::kappa
