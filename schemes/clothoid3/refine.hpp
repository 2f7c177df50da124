#pragma once

#include <vector>

#include "schemes/clothoid3/elements.hpp"

namespace kappabench::clothoid3 {

enum class Pieces { three_arcs, clc };

/// Raises |curvature| at the points of a run until its spans are good, one growth factor a span and every span on its
/// own (step 5 of README.md). A point takes the largest value that its two spans ask for, so that a span may still miss
/// its property. Signs stay.
void refine(std::vector<PointElement>& elements, bool closed, Pieces pieces, const Rules& rules);

/// The property that refinement of three arcs aims at: curvature monotone between opposite signs; else nowhere on the
/// middle arc above that of the points.
[[nodiscard]] bool good(const ThreeArcs& span, double curvature0, double curvature1, const Rules& rules);

}  // namespace kappabench::clothoid3
