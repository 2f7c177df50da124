#pragma once

#include <vector>

#include "schemes/api/input.hpp"
#include "schemes/clothoid3/rules.hpp"

namespace kappabench::clothoid3 {

/// A stretch of the input between corners, fitted on its own: indices of points in order. A closed run is the whole of
/// a closed input without corners; an open run repeats the corner at its end in the next one.
struct Run {
  std::vector<std::size_t> points;
  bool closed;

  [[nodiscard]] std::size_t spans() const { return closed ? points.size() : points.size() - 1; }
};

/// The runs of an input. Corners are points where the legs turn straight back; with the published rules instead both
/// points of pairs that are closer than the corner distance.
[[nodiscard]] std::vector<Run> runs_of(const Input& input, const Rules& rules);

}  // namespace kappabench::clothoid3
