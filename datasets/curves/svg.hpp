#pragma once

#include <string_view>
#include <vector>

#include "datasets/curves/pen.hpp"

namespace kappabench {

/// The curves of an SVG document, one for each subpath of what it draws: path, line, polyline, polygon, rect, circle
/// and ellipse, where their transforms and those of all elements around them put them (README.md). In user units of the
/// outermost element, mirrored so that y points up. `file` is what messages call the document. Throws DataError, one
/// line with file:line, for what is no SVG, for what cannot be read, and where nothing is drawn.
[[nodiscard]] std::vector<Outline> read_svg(std::string_view text, std::string_view file);

}  // namespace kappabench
