#pragma once

#include "schemes/kappa/cascade.hpp"

namespace kappabench::kappa {

/// Segments [begin, begin + length) of a chain, counted from 1, around the seam if the chain is closed.
struct Window {
  std::size_t begin, length;
};

/// Number `k` counted from the segment before the window, as a number of the chain, 0 to m + 1.
[[nodiscard]] std::size_t number_in(const ChordChain& chain, const Window& window, std::size_t k);

/// A window as a chain of its own: control points beside it and its outer joints' ratios stay.
struct ChainPart {
  ChordChain chain;
  State state;
  Setting setting;
};
[[nodiscard]] ChainPart part_of(const ChordChain& chain, const State& state, const Setting& setting,
                                const Window& window);

/// Puts the state and setting of a window into those of the chain.
void put_back(const ChordChain& chain, const Window& window, const State& part, const Setting& part_setting,
              State& state, Setting& setting);

}  // namespace kappabench::kappa
