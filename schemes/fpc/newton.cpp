#include "schemes/fpc/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kappabench::fpc {
namespace {

constexpr double longest_step = 2.0;
constexpr int halvings = 12;

}  // namespace

void advance(const CubicChain& chain, const State& state, std::span<const Right3> step, double factor, double longest,
             State& to) {
  to = state;
  for (std::size_t k = 0; k < chain.segments(); ++k) {
    const Vec2 shift = step[k].head<2>();
    const double length = std::max(shift.norm() / chain.size[k], std::abs(step[k](2)));
    const double part = factor * (length > longest ? longest / length : 1.0);
    if (k < chain.joints()) to.shift(chain, k, part * shift);
    to.log_weight[k] += part * step[k](2);
  }
}

Newton::Result Newton::run(State& state, double softness, int steps, double tolerance) {
  system_->evaluate(state, softness, values_);
  for (int i = 0; i < steps; ++i) {
    if (values_.worst <= tolerance) return {true, i};
    if (!step(state, softness)) return {false, i};
    if (observer_) observer_(state);
  }
  return {values_.worst <= tolerance, steps};
}

bool Newton::solve(double softness) {
  system_->linearise(values_, softness, matrix_, right_);
  if (!solver_.solve(matrix_, right_)) return false;
  for (std::size_t k = 0; k < right_.size(); ++k) right_[k].head<2>() *= values_.segment[k].stride;
  return true;
}

int Newton::polish(State& state, double softness, int steps) {
  const CubicChain& chain = system_->chain();
  double reached = residual_of(chain, state, system_->log_ratios(state));
  for (int i = 0; i < steps; ++i) {
    system_->evaluate(state, softness, values_);
    if (!solve(softness)) return i;
    advance(chain, state, right_, 1.0, longest_step, trial_);
    const double trial = residual_of(chain, trial_, system_->log_ratios(trial_));
    if (!(trial < reached)) return i;
    std::swap(state, trial_);
    reached = trial;
    if (observer_) observer_(state);
  }
  return steps;
}

bool Newton::step(State& state, double softness) {
  if (!solve(softness)) return false;
  double fraction = 1.0;
  for (int i = 0; i < halvings; ++i, fraction *= 0.5) {
    advance(system_->chain(), state, right_, fraction, longest_step, trial_);
    system_->evaluate(trial_, softness, trial_values_);
    if (std::isfinite(trial_values_.merit) && trial_values_.merit < (1.0 - 1e-4 * fraction) * values_.merit) {
      std::swap(state, trial_);
      std::swap(values_, trial_values_);
      return true;
    }
  }
  return false;
}

}  // namespace kappabench::fpc
