#pragma once

#include <string_view>

#include "datasets/curves/pen.hpp"

namespace kappabench {

/// Draws path data, the attribute `d` of SVG (SVG 2, 9.3): every command, absolute and relative. Throws DataError at
/// the first thing that is none; what was drawn until there is not to be used.
void draw_path(std::string_view data, const Place& place, Pen& pen);

/// Draws what the attribute `points` of polyline and polygon lists, as a line through all of them.
void draw_points(std::string_view points, const Place& place, Pen& pen);

}  // namespace kappabench
