#include "schemes/kappa/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kappabench::kappa {
namespace {

constexpr double longest_step = 4.0;  ///< of x, and of e in units of the point's size
constexpr int halvings = 12;

/// state + fraction * step, clipped at each point.
void advance(const ChordChain& chain, const State& state, const std::vector<Right4>& step, double fraction, State& to) {
  const std::size_t m = chain.segments();
  to = state;
  for (std::size_t i = 1; i <= m; ++i) {
    const Right4& s = step[i - 1];
    const Vec2 e = s.head<2>();
    const double length = e.norm() / chain.size[i];
    to.e[i] += fraction * std::min(1.0, longest_step / length) * e;
    if (chain.closed || i < m) to.x[i] += fraction * std::clamp(s(2), -longest_step, longest_step);
  }
  to.close(chain);
}

}  // namespace

Newton::Result Newton::run(State& state, const Setting& setting, int steps, double tolerance) {
  system_->evaluate(state, setting, values_);
  for (int i = 0; i < steps; ++i) {
    if (values_.residual <= tolerance) return {true, i};
    if (!step(state, setting)) return {false, i};
    if (observer_) observer_(state);
  }
  return {values_.residual <= tolerance, steps};
}

bool Newton::step(State& state, const Setting& setting) {
  system_->linearise(state, setting, values_, jacobian_, right_);
  if (!solver_.solve(jacobian_, right_)) return false;
  double fraction = 1.0;
  for (int i = 0; i < halvings; ++i, fraction *= 0.5) {
    advance(system_->chain(), state, right_, fraction, trial_);
    system_->evaluate(trial_, setting, trial_values_);
    if (std::isfinite(trial_values_.residual) && trial_values_.merit < (1.0 - 1e-4 * fraction) * values_.merit) {
      std::swap(state, trial_);
      std::swap(values_, trial_values_);
      return true;
    }
  }
  return false;
}

}  // namespace kappabench::kappa
