#pragma once

#include <functional>

#include "schemes/fpc/system.hpp"

namespace kappabench::fpc {

/// Pseudo-arc-length continuation (Keller 1977) of the softened equations in the logarithm of the softness: it goes
/// round the folds of the solution path, and its steps fit the path's curvature where a homotopy creeps.
class Continuation {
 public:
  /// Sees every accepted point of the path; true means stop.
  using Visitor = std::function<bool(const State& state, double softness)>;

  explicit Continuation(const System& system) : system_(&system) {}

  /// Follows the path from `state`, a solution for `softness`, at first towards less softness, for at most `most`
  /// linear solves. Returns their number. Ends early when the path leaves the range of softness or no step works.
  long follow(const State& state, double softness, long most, const Visitor& visit);

 private:
  /// A direction, by segment and in log softness, of unit length where joints count in sizes.
  struct Tangent {
    std::vector<Right3> by_segment;
    double by_log = 0.0;
    double cosine = 1.0;  ///< with the direction before
  };
  using Right = BlockRight<3, 2>;

  /// Newton's step for the equations alone and the response to log softness, as the two columns of `right_`.
  [[nodiscard]] bool solve(double softness);
  /// The direction of the path, onwards from `before`; of that only `by_log` counts if it has no segments.
  [[nodiscard]] bool tangent(double softness, const Tangent& before, Tangent& to);
  /// Newton across the path until the equations hold; the number of corrections, or -1.
  [[nodiscard]] int correct(State& state, double& softness, const Tangent& along);
  [[nodiscard]] double product(const Tangent& along, int column) const;

  const System* system_;
  Values values_;
  State trial_;
  Block3 matrix_;
  std::vector<Right3> newton_, response_;
  std::vector<Right> right_;
  BlockTridiagonalSolver<3, 2> solver_;
  long solves_ = 0;
};

}  // namespace kappabench::fpc
