#pragma once

#include <string>
#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// What is legal but wild in spans, a span being the piece between the nodes of two points that follow one another.
struct Warning {
  std::string name;   ///< long_span, self_crossing_span or winding_span
  long spans;         ///< how many
  std::string first;  ///< the first one, in words
};

/// `long_span`: longer than 3 chords. `self_crossing_span`: crosses itself. `winding_span`: turns by more than 2 pi in
/// all. A loop that a user put at a point lies between two nodes of that point and is no span. Seen on 33 samples of
/// each segment of a span, unless the control points show already that there is nothing to see. In this order.
[[nodiscard]] std::vector<Warning> warnings_of(const Curve& curve);

}  // namespace kappabench
