#include "schemes/kappa/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kappabench::kappa {
namespace {

constexpr double least_softness = 1e-9, most_softness = 1e4;
constexpr double first_length = 0.3, shortest_length = 1e-5;
constexpr double longest_in_log = 2.0;  ///< of one step in log softness
constexpr double tolerance = 1e-6;      ///< to which each point of the path is solved
constexpr double least_cosine = 0.8;    ///< between the directions of neighbouring points
constexpr int corrections = 8, easy_corrections = 3;
constexpr double difference = 1e-4;  ///< step of the numerical derivative by log softness

/// state + factor * change.
template <class Change>
void add(const Chain& chain, double factor, const Change& change, State& state) {
  const std::size_t m = chain.segments();
  for (std::size_t i = 1; i <= m; ++i) {
    const Right4 c = change(i);
    state.e[i] += factor * c.head<2>();
    if (chain.closed || i < m) state.x[i] += factor * c(2);
  }
  state.close(chain);
}

}  // namespace

double Continuation::product(const Tangent& along, int column) const {
  const Chain& chain = system_->chain();
  double sum = 0.0;
  for (std::size_t i = 1; i <= chain.segments(); ++i) {
    const Right4 c = right_[i - 1].col(column);
    const Right4& t = along.by_point[i - 1];
    sum += c.head<2>().dot(t.head<2>()) / (chain.size[i] * chain.size[i]) + c(2) * t(2);
  }
  return sum;
}

double Continuation::response() const {
  const Chain& chain = system_->chain();
  double sum = 1.0;
  for (std::size_t i = 1; i <= chain.segments(); ++i) {
    const Right4 c = right_[i - 1].col(1);
    sum += c.head<2>().squaredNorm() / (chain.size[i] * chain.size[i]) + c(2) * c(2);
  }
  return std::sqrt(sum);
}

bool Continuation::solve(const State& state, const Setting& setting, const Values& values) {
  ++solves_;
  system_->linearise(state, setting, values, jacobian_, residuals_);
  Setting shifted = setting;
  shifted.softness *= std::exp(difference);
  system_->evaluate(state, shifted, shifted_);
  const std::size_t m = system_->chain().segments();
  right_.resize(m);
  for (std::size_t i = 1; i <= m; ++i) {
    right_[i - 1].col(0) = residuals_[i - 1];
    const Vec2 miss = (shifted_.miss[i] - values.miss[i]) / difference;
    right_[i - 1].col(1) << -miss.x(), -miss.y(), -(shifted_.bend[i] - values.bend[i]) / difference, 0.0;
  }
  return solver_.solve(jacobian_, right_);
}

bool Continuation::tangent(const State& state, const Setting& setting, const Values& values, const Tangent& before,
                           Tangent& to) {
  if (!solve(state, setting, values)) return false;
  const double norm = response();
  if (!std::isfinite(norm)) return false;
  // Onwards: the same way as the last step.
  const double way = before.by_point.empty() ? before.by_log : product(before, 1) + before.by_log;
  const double scale = (way < 0.0 ? -1.0 : 1.0) / norm;
  to.cosine = std::abs(way) / norm;
  to.by_log = scale;
  to.by_point.clear();
  for (const Right& r : right_) to.by_point.push_back(scale * r.col(1));
  return true;
}

/// Newton across the path until the equations hold; the number of corrections, or -1.
int Continuation::correct(State& state, Setting& setting, const Tangent& along) {
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= corrections; ++i) {
    system_->evaluate(state, setting, values_);
    if (values_.residual <= tolerance) return i;
    if (!(values_.residual < 2.0 * before) || i == corrections || !solve(state, setting, values_)) return -1;
    before = values_.residual;
    const double by_log = -product(along, 0) / (along.by_log + product(along, 1));
    if (!(std::abs(by_log) < longest_in_log)) return -1;
    const auto correction = [&](std::size_t k) -> Right4 { return right_[k - 1] * Vec2(1.0, by_log); };
    add(system_->chain(), 1.0, correction, state);
    setting.softness *= std::exp(by_log);
  }
  return -1;
}

long Continuation::follow(const State& start, const Setting& start_setting, bool down, long most,
                          const Visitor& visit) {
  solves_ = 0;
  State state = start;
  Setting setting = start_setting;
  Tangent along, next;
  system_->evaluate(state, setting, values_);
  if (!tangent(state, setting, values_, {.by_point = {}, .by_log = down ? -1.0 : 1.0}, along)) return solves_;
  double reach = first_length;
  while (solves_ < most && reach > shortest_length) {
    const double step = std::min(reach, longest_in_log / std::abs(along.by_log));
    State trial = state;
    Setting trial_setting = setting;
    const auto onwards = [&](std::size_t k) -> const Right4& { return along.by_point[k - 1]; };
    add(system_->chain(), step, onwards, trial);
    trial_setting.softness *= std::exp(step * along.by_log);
    const int corrected = correct(trial, trial_setting, along);
    // A path that turns sharply within one step would be followed back to where it came from.
    if (corrected < 0 || !tangent(trial, trial_setting, values_, along, next) || next.cosine < least_cosine) {
      reach = 0.5 * step;
      continue;
    }
    state = std::move(trial);
    setting.softness = trial_setting.softness;
    std::swap(along, next);
    if (setting.softness < least_softness || setting.softness > most_softness) break;
    if (visit(state, values_, setting.softness)) break;
    reach = corrected <= easy_corrections ? 2.0 * step : step;
  }
  return solves_;
}

}  // namespace kappabench::kappa
