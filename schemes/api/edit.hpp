#pragma once

#include <variant>

#include "schemes/api/input.hpp"

namespace kappabench {

/// One change of an input, for Scheme::refit.
struct Move {
  int point;
  Vec2 to;
};
struct Insert {
  int before;  ///< index the new point will have, 0 to size
  Vec2 at;
  PointOptions options{};
};
struct Erase {
  int point;
};

using Edit = std::variant<Move, Insert, Erase>;

/// The input after the edit. Ids of the other points stay; an inserted point gets the smallest unused id.
/// Throws std::out_of_range when the edit names a point that is not there.
[[nodiscard]] Input apply(const Input& input, const Edit& edit);

}  // namespace kappabench
