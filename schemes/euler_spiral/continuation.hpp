#pragma once

#include "schemes/euler_spiral/newton.hpp"

namespace kappabench::euler_spiral {

/// Where the path from small turns has led.
struct Reached {
  Found at;
  double bend;  ///< the part of all turns: 1 if the path goes so far
};

/// Follows the spline from the polygon whose turns are a twentieth of what they are, where it is nearly straight, as
/// all turns grow together. Round the folds of the path, in arc length (Keller 1977). It ends at the whole turns, where
/// Newton's method finishes; or where a span runs away, its length growing beyond all bounds.
[[nodiscard]] Reached from_small_turns(System& system, std::size_t points);

}  // namespace kappabench::euler_spiral
