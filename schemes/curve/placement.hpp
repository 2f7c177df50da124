#pragma once

#include "schemes/curve/vec.hpp"

namespace kappabench {

/// p becomes scale * p + shift: how a drawing's own frame lies in the plane. With a power of two as scale and numbers
/// of one size, placing and placing back rounds once, to the coordinates far out.
struct Placement {
  double scale = 1.0;  ///< > 0
  Vec2 shift = Vec2::Zero();

  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return scale * p + shift; }
  [[nodiscard]] Placement inverse() const { return {1.0 / scale, -shift / scale}; }
  [[nodiscard]] bool is_identity() const { return scale == 1.0 && shift == Vec2::Zero(); }
};

}  // namespace kappabench
