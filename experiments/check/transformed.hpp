#pragma once

#include <numbers>
#include <vector>

#include "metrics/correspondence.hpp"
#include "schemes/api/scheme.hpp"

namespace kappabench::check {

/// x -> scale * turn(mirror(x)) + shift.
struct Similarity {
  double scale = 1.0;
  double angle = 0.0;
  Vec2 shift = Vec2::Zero();
  bool mirror = false;

  [[nodiscard]] Vec2 operator()(const Vec2& p) const;
  /// Of directions, derivatives, differences.
  [[nodiscard]] Vec2 linear(Vec2 p) const;
  [[nodiscard]] Similarity inverse() const;
};

/// Tangents and curvatures that a user has given move along.
[[nodiscard]] Input transformed(Input input, const Similarity& map);

/// The curve under the map.
[[nodiscard]] Curve transformed(const Curve& curve, const Similarity& map);

/// The points in another order: new point i is old point order[i].
[[nodiscard]] Input reordered(const Input& input, const std::vector<int>& order);
/// The same, with what the options say of before and after exchanged, for the order that runs backwards.
[[nodiscard]] Input reversed(const Input& input, const std::vector<int>& order);
[[nodiscard]] std::vector<Span> with_old_names(std::vector<Span> renamed, const std::vector<int>& order);

}  // namespace kappabench::check
