#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace kappabench {

/// How far a path may run.
struct PathLimits {
  double least_softness, most_softness;
  double longest_in_log;   ///< of one step in log softness
  double shortest_length;  ///< a step below which the path has ended
};

/// Pseudo-arc-length continuation (Keller 1977) of softened equations in the logarithm of the softness: unlike a
/// homotopy that only lowers the softness, it goes round the folds of the solution path. A Problem has
///   State, Step                                    its unknowns, and a change of them in lengths
///   double evaluate(state, softness)               the largest equation there, kept for `solve`
///   bool solve(state, softness, newton, response)  Newton's step, and the response to log softness
///   double dot(a, b, start)                        start + the scalar product, unknowns in units of their size
///   void advance(from, step, factor, to)           to = from + factor * step
template <class Problem>
class ArcLengthPath {
 public:
  using State = typename Problem::State;
  using Step = typename Problem::Step;

  ArcLengthPath(Problem& problem, const PathLimits& limits) : problem_(problem), limits_(limits) {}

  /// Follows the path from `state`, a solution for `softness`, at first towards less softness if `down`, for at most
  /// `most` linear solves. Returns their number. `visit(state, softness)` sees every accepted point; true means stop.
  /// Ends early when the path leaves the range of softness or no step works.
  template <class Visit>
  long follow(State state, double softness, bool down, long most, Visit visit) {
    solves_ = 0;
    State trial;
    Tangent along, next;
    problem_.evaluate(state, softness);
    if (!tangent(state, softness, {.step = {}, .by_log = down ? -1.0 : 1.0, .cosine = 1.0}, along)) return solves_;
    double reach = first_length;
    while (solves_ < most && reach > limits_.shortest_length) {
      const double length = std::min(reach, limits_.longest_in_log / std::abs(along.by_log));
      problem_.advance(state, along.step, length, trial);
      double trial_softness = softness * std::exp(length * along.by_log);
      const int corrected = correct(trial, trial_softness, along);
      // A path that turns sharply within one step would be followed back to where it came from.
      if (corrected < 0 || !tangent(trial, trial_softness, along, next) || next.cosine < least_cosine) {
        reach = 0.5 * length;
        continue;
      }
      std::swap(state, trial);
      softness = trial_softness;
      std::swap(along, next);
      if (softness < limits_.least_softness || softness > limits_.most_softness || visit(state, softness)) break;
      reach = corrected <= easy_corrections ? 2.0 * length : length;
    }
    return solves_;
  }

 private:
  static constexpr double first_length = 0.3;
  static constexpr double tolerance = 1e-6;    ///< to which each point of the path is solved
  static constexpr double least_cosine = 0.8;  ///< between the directions of neighbouring points
  static constexpr int corrections = 8, easy_corrections = 3;

  /// A direction, in the unknowns and in log softness, of unit length.
  struct Tangent {
    Step step;
    double by_log = 0.0;
    double cosine = 1.0;  ///< with the direction before
  };

  bool solve(const State& state, double softness) {
    ++solves_;
    return problem_.solve(state, softness, newton_, response_);
  }

  /// The direction of the path, onwards from `before`; of that only `by_log` counts if it has no step.
  bool tangent(const State& state, double softness, const Tangent& before, Tangent& to) {
    if (!solve(state, softness)) return false;
    const double norm = std::sqrt(problem_.dot(response_, response_, 1.0));
    if (!std::isfinite(norm)) return false;
    // Onwards: the same way as the last step.
    const double way = before.step.empty() ? before.by_log : problem_.dot(before.step, response_, 0.0) + before.by_log;
    to.by_log = (way < 0.0 ? -1.0 : 1.0) / norm;
    to.cosine = std::abs(way) / norm;
    to.step.clear();
    for (const auto& r : response_) to.step.emplace_back(to.by_log * r);
    return true;
  }

  /// Newton across the path until the equations hold; the number of corrections, or -1.
  int correct(State& state, double& softness, const Tangent& along) {
    double before = std::numeric_limits<double>::infinity();
    State next;
    for (int i = 0; i <= corrections; ++i) {
      const double residual = problem_.evaluate(state, softness);
      if (residual <= tolerance) return i;
      if (!(residual < 2.0 * before) || i == corrections || !solve(state, softness)) return -1;
      before = residual;
      const double by_log =
          -problem_.dot(along.step, newton_, 0.0) / (along.by_log + problem_.dot(along.step, response_, 0.0));
      if (!(std::abs(by_log) < limits_.longest_in_log)) return -1;
      for (std::size_t k = 0; k < newton_.size(); ++k) newton_[k] += by_log * response_[k];
      problem_.advance(state, newton_, 1.0, next);
      std::swap(state, next);
      softness *= std::exp(by_log);
    }
    return -1;
  }

  Problem& problem_;
  PathLimits limits_;
  Step newton_, response_;
  long solves_ = 0;
};

}  // namespace kappabench
