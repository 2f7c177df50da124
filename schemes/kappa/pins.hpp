#pragma once

#include "schemes/kappa/system.hpp"

namespace kappabench::kappa {

// A point is pinned when the peak of |kappa| on the closed segment sits at an end: then the joint there is the input
// point itself (X = 0 or Y = 0). The published equations have no solution in that case.

/// Which points are about to be pinned, judged at a state and values of a softened problem: those whose stationary
/// point has come near an end towards which |kappa| rises. All others get the divided form.
[[nodiscard]] Setting guess_pins(const ChordChain& chain, const State& state, const Values& values);

/// Frees the pinned points where |kappa| falls towards their end, and pins the free ones whose stationary point ran
/// into one. Returns how many it changed; 0 means that `setting` is consistent with the state.
int correct_pins(const ChordChain& chain, const State& state, const Values& values, Setting& setting);

/// Pins the free point that misses most among those where |kappa| peaks at an end. False if there is none.
[[nodiscard]] bool pin_worst(const ChordChain& chain, const State& state, const Values& values, Setting& setting);

}  // namespace kappabench::kappa
