#pragma once

#include <vector>

#include "schemes/fpc/system.hpp"

namespace kappabench::fpc {

/// What it took.
struct Effort {
  long sweeps = 0;    ///< linear solves for the joints alone
  long newton = 0;    ///< Newton and path-following steps
  long attempts = 0;  ///< entries of the cascade that were tried
  [[nodiscard]] long iterations() const { return sweeps + newton; }
  Effort& operator+=(const Effort& other);
};

/// The state a solver ended with.
struct Solution {
  State state;
  bool converged = false;
  double residual = 0.0;  ///< residual_of(state)
  Effort effort;
  double iterations = 0.0;    ///< steps that a point went through, on average
  std::vector<double> trace;  ///< residual_of before the first and after each iteration, when asked for
};

/// Residual below which a state is a solution.
inline constexpr double accuracy = 1e-12;

/// Solves one chain as a whole, trying in turn until one way succeeds: damped sweeps and Newton; a homotopy in the
/// softness; the same path by arc length. When `near` is given, Newton from there comes first. Deterministic.
[[nodiscard]] Solution solve_chain(const CubicChain& chain, const State* near, bool trace);

}  // namespace kappabench::fpc
