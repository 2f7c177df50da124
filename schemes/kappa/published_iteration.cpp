#include "schemes/kappa/published_iteration.hpp"

#include <algorithm>

namespace kappabench::kappa {

bool PublishedIteration::step(State& state) {
  const ChordChain& chain = system_->chain();
  const std::size_t m = chain.segments();
  system_->evaluate_jumps(state, 0.0, values_);
  next_ = state;
  // Eq. (10), corrected to |Delta|: logit lambda_i is half the log of (1 - a_i) |Delta_i+| a_{i+1}^2 over
  // (1 - a_{i+1}) |Delta_{i+1}-| a_i^2, which is half the G2 equation away. The bound keeps lambda inside (0, 1).
  for (std::size_t i = 1; i <= (chain.closed ? m : m - 1); ++i)
    next_.x[i] = std::clamp(state.x[i] + 0.5 * values_.jump[i], -30.0, 30.0);
  next_.close(chain);

  const Ratios ratios = ratios_of(next_);
  matrix_.cyclic = chain.closed;
  matrix_.resize(m);
  right_.resize(m);
  for (std::size_t i = 1; i <= m; ++i) {
    const Blend b = stationary_blend(chain, i, ends(chain, next_, ratios, i));
    const double before = b.b0 * ratios.rest[i - 1], after = b.b2 * ratios.lambda[i];
    // Eq. (11) minus p_i, since the coefficients sum to one.
    matrix_.lower[i - 1](0, 0) = before;
    matrix_.diagonal[i - 1](0, 0) = b.b0 * ratios.lambda[i - 1] + b.b1 + b.b2 * ratios.rest[i];
    matrix_.upper[i - 1](0, 0) = after;
    right_[i - 1] = (before * chain.chord[i - 1] - after * chain.chord[i]).transpose();
    if (!chain.closed && i == 1) right_[i - 1] -= before * state.e[0].transpose();
    if (!chain.closed && i == m) right_[i - 1] -= after * state.e[m + 1].transpose();
  }
  if (!solver_.solve(matrix_, right_)) return false;
  for (std::size_t i = 1; i <= m; ++i) next_.e[i] = right_[i - 1].transpose();
  next_.close(chain);
  std::swap(state, next_);
  return true;
}

int PublishedIteration::steps(State& state, int count) {
  int done = 0;
  while (done < count && step(state)) ++done;
  return done;
}

}  // namespace kappabench::kappa
