#pragma once

#include <functional>

#include "schemes/kappa/system.hpp"

namespace kappabench::kappa {

/// Pseudo-arc-length continuation (Keller 1977) of the softened equations in the logarithm of the softness: unlike a
/// homotopy that only lowers the softness, it goes round the folds of the solution path.
class Continuation {
 public:
  /// Sees every accepted point of the path; true means stop.
  using Visitor = std::function<bool(const State& state, const Values& values, double softness)>;

  explicit Continuation(const System& system) : system_(&system) {}

  /// Follows the path from `state`, a solution of `setting`, at first towards less softness if `down`, for at most
  /// `most` linear solves. Returns their number. Ends early when the path leaves the range of softness or no step
  /// works.
  long follow(const State& state, const Setting& setting, bool down, long most, const Visitor& visit);

 private:
  using Right = BlockRight<4, 2>;

  /// A direction, by point and in log softness, of unit length where e counts in units of the point's size.
  struct Tangent {
    std::vector<Right4> by_point;
    double by_log = 0.0;
    double cosine = 1.0;  ///< with the direction before
  };

  /// Newton's step for the equations alone and the response to log softness, as the two columns of `right_`.
  [[nodiscard]] bool solve(const State& state, const Setting& setting, const Values& values);
  /// The direction of the path, onwards from `before`; of that only `by_log` counts if it has no points.
  [[nodiscard]] bool tangent(const State& state, const Setting& setting, const Values& values, const Tangent& before,
                             Tangent& to);
  [[nodiscard]] int correct(State& state, Setting& setting, const Tangent& along);
  [[nodiscard]] double product(const Tangent& along, int column) const;
  /// Length of the response to log softness, with a unit of log softness.
  [[nodiscard]] double response() const;

  const System* system_;
  Values values_, shifted_;
  Block4 jacobian_;
  std::vector<Right4> residuals_;
  std::vector<Right> right_;
  BlockTridiagonalSolver<4, 2> solver_;
  long solves_ = 0;
};

}  // namespace kappabench::kappa
