#pragma once

#include <vector>

#include "schemes/api/input.hpp"
#include "schemes/clothoid3/hermite.hpp"
#include "schemes/clothoid3/rules.hpp"
#include "schemes/clothoid3/runs.hpp"

namespace kappabench::clothoid3 {

/// What the spans on both sides of a point share.
struct PointElement {
  CurveElement at;
  int turn;              ///< 1 left, -1 right, 0: the legs are aligned
  bool given_curvature;  ///< by the user: not to be refined
};

/// Heading and curvature at every point of a run of three or more, from its neighbours (steps 2 and 3 of README.md), or
/// as the options of the points say.
[[nodiscard]] std::vector<PointElement> elements_of(const Input& input, const Run& run, const Rules& rules);

}  // namespace kappabench::clothoid3
