#pragma once

#include "schemes/fpc/cascade.hpp"

namespace kappabench::fpc {

/// Longer chains are solved in windows.
inline constexpr std::size_t longest_whole_chain = 256;

/// Solves a long chain in overlapping windows between two of its joints, all once, then those spots whose equations
/// are still open with other overlaps; Newton on the whole chain finishes. A point's influence on a joint falls
/// exponentially with their distance, so that this is linear in the length and one difficult spot does not slow the
/// rest. The order is fixed.
[[nodiscard]] Solution solve_in_windows(const CubicChain& chain);

/// solve_chain or solve_in_windows, by length. The trace of a long chain has one entry for each pass.
[[nodiscard]] Solution solve(const CubicChain& chain);

}  // namespace kappabench::fpc
