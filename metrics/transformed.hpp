#pragma once

#include <vector>

#include "metrics/correspondence.hpp"
#include "schemes/api/input.hpp"

namespace kappabench {

/// x -> scale * turn(mirror(x)) + shift.
struct Similarity {
  double scale = 1.0;
  double angle = 0.0;  ///< radians
  Vec2 shift = Vec2::Zero();
  bool mirror = false;

  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return linear(p) + shift; }
  /// Of directions, derivatives, differences.
  [[nodiscard]] Vec2 linear(Vec2 p) const;
  [[nodiscard]] Similarity inverse() const;
};

/// Tangents and curvatures that a user has given move along.
[[nodiscard]] Input transformed(Input input, const Similarity& map);

/// The points in another order: new point i is old point order[i].
[[nodiscard]] Input reordered(const Input& input, const std::vector<int>& order);
/// The same, with what the options say of before and after exchanged, for the order that runs backwards.
[[nodiscard]] Input reversed(const Input& input, const std::vector<int>& order);
[[nodiscard]] std::vector<Span> with_old_names(std::vector<Span> renamed, const std::vector<int>& order);

/// Every point moved by `step`, a length, in directions that turn by the golden angle, from `start`, radians.
[[nodiscard]] Input perturbed(Input input, double step, double start = 0.0);

}  // namespace kappabench
