#pragma once

#include <vector>

#include "schemes/kappa/newton.hpp"
#include "schemes/kappa/published_iteration.hpp"

namespace kappabench::kappa {

/// What it took.
struct Effort {
  long sweeps = 0;    ///< steps of the published iteration
  long newton = 0;    ///< Newton steps
  long attempts = 0;  ///< entries of the cascade that were tried
  [[nodiscard]] long iterations() const { return sweeps + newton; }
  Effort& operator+=(const Effort& other);
};

/// The state a cascade ended with, and the equations it satisfies or was last tried against.
struct Solution {
  State state;
  Setting setting;
  bool converged = false;
  double residual = 0.0;  ///< residual_of(state)
  Effort effort;
  double iterations = 0.0;    ///< sweeps and Newton steps that a point went through, on average
  std::vector<double> trace;  ///< residual_of before the first and after each iteration, when asked for
};

/// Which entries of the cascade to try before giving up: none but Newton from `near`, the first two homotopies, all.
enum class Attempts { near, usual, all };

/// Residual below which a state is a solution.
inline constexpr double accuracy = 1e-12;

/// Solves one chain as a whole: homotopies from a softened problem, from several starts and in several forms, until
/// one arrives. `start` gives the values of the fixed ends and the first guess; when `near` is given it is near a
/// solution with these forms, and Newton from there is tried first. Deterministic.
[[nodiscard]] Solution solve_chain(const ChordChain& chain, const State& start, const Setting* near, Attempts attempts,
                                   bool trace);

}  // namespace kappabench::kappa
