#include "schemes/fpc/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "schemes/fpc/newton.hpp"

namespace kappabench::fpc {
namespace {

constexpr double least_softness = 1e-25, most_softness = 1e4;
constexpr double first_length = 0.3, shortest_length = 1e-6;
constexpr double longest_in_log = 4.0;  ///< of one step in log softness
constexpr double tolerance = 1e-6;      ///< to which each point of the path is solved
constexpr double least_cosine = 0.8;    ///< between the directions of neighbouring points
constexpr int corrections = 8, easy_corrections = 3;
constexpr double unlimited = std::numeric_limits<double>::infinity();

double product_at(double size, const Right3& a, const Right3& b) {
  return a.head<2>().dot(b.head<2>()) / (size * size) + a(2) * b(2);
}

}  // namespace

double Continuation::product(const Tangent& along, int column) const {
  const Chain& chain = system_->chain();
  double sum = 0.0;
  for (std::size_t k = 0; k < chain.segments(); ++k)
    sum += product_at(chain.size[k], right_[k].col(column), along.by_segment[k]);
  return sum;
}

bool Continuation::solve(double softness) {
  ++solves_;
  system_->linearise(values_, softness, matrix_, newton_);
  system_->by_softness(values_, softness, response_);
  right_.resize(newton_.size());
  for (std::size_t k = 0; k < right_.size(); ++k) {
    right_[k].col(0) = newton_[k];
    right_[k].col(1) = response_[k];
  }
  if (!solver_.solve(matrix_, right_)) return false;
  // Units change along the path: directions are kept in lengths.
  for (std::size_t k = 0; k < right_.size(); ++k) right_[k].topRows<2>() *= values_.segment[k].unit;
  return true;
}

bool Continuation::tangent(double softness, const Tangent& before, Tangent& to) {
  if (!solve(softness)) return false;
  const Chain& chain = system_->chain();
  double square = 1.0;
  for (std::size_t k = 0; k < right_.size(); ++k)
    square += product_at(chain.size[k], right_[k].col(1), right_[k].col(1));
  const double norm = std::sqrt(square);
  if (!std::isfinite(norm)) return false;
  // Onwards: the same way as the last step.
  const double way = before.by_segment.empty() ? before.by_log : product(before, 1) + before.by_log;
  const double scale = (way < 0.0 ? -1.0 : 1.0) / norm;
  to.cosine = std::abs(way) / norm;
  to.by_log = scale;
  to.by_segment.clear();
  for (const Right& r : right_) to.by_segment.emplace_back(scale * r.col(1));
  return true;
}

int Continuation::correct(State& state, double& softness, const Tangent& along) {
  double before = unlimited;
  for (int i = 0; i <= corrections; ++i) {
    system_->evaluate(state, softness, values_);
    if (values_.worst <= tolerance) return i;
    if (!(values_.worst < 2.0 * before) || i == corrections || !solve(softness)) return -1;
    before = values_.worst;
    const double by_log = -product(along, 0) / (along.by_log + product(along, 1));
    if (!(std::abs(by_log) < longest_in_log)) return -1;
    for (std::size_t k = 0; k < right_.size(); ++k) newton_[k] = right_[k].col(0) + by_log * right_[k].col(1);
    advance(system_->chain(), state, newton_, 1.0, unlimited, trial_);
    std::swap(state, trial_);
    softness *= std::exp(by_log);
  }
  return -1;
}

long Continuation::follow(const State& start, double start_softness, long most, const Visitor& visit) {
  solves_ = 0;
  State state = start, trial;
  double softness = start_softness;
  Tangent along, next;
  system_->evaluate(state, softness, values_);
  if (!tangent(softness, {.by_segment = {}, .by_log = -1.0}, along)) return solves_;
  double reach = first_length;
  while (solves_ < most && reach > shortest_length) {
    const double step = std::min(reach, longest_in_log / std::abs(along.by_log));
    advance(system_->chain(), state, along.by_segment, step, unlimited, trial);
    double trial_softness = softness * std::exp(step * along.by_log);
    const int corrected = correct(trial, trial_softness, along);
    // A path that turns sharply within one step would be followed back to where it came from.
    if (corrected < 0 || !tangent(trial_softness, along, next) || next.cosine < least_cosine) {
      reach = 0.5 * step;
      continue;
    }
    std::swap(state, trial);
    softness = trial_softness;
    std::swap(along, next);
    if (softness < least_softness || softness > most_softness || visit(state, softness)) break;
    reach = corrected <= easy_corrections ? 2.0 * step : step;
  }
  return solves_;
}

}  // namespace kappabench::fpc
