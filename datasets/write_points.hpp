#pragma once

#include <ostream>

#include "datasets/drawing.hpp"

namespace kappabench {

/// Writes plain text that read_drawing reads back: metadata (line breaks become spaces), open or closed for every
/// curve, coordinates and options with 17 significant digits. Points and options come back bit for bit; a tangent
/// goes through degrees, so one that did not come from a file may change in its last bit. The id (a file has its
/// name) and the ids of points are not written.
/// Throws std::invalid_argument for what the format cannot say: a curve without points, a number that is not finite.
/// The state of `out` is for the caller to check.
void write_points(std::ostream& out, const Drawing& drawing);

}  // namespace kappabench
