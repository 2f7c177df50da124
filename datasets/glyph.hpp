#pragma once

#include <string>
#include <string_view>

#include "datasets/drawing.hpp"

namespace kappabench {

/// "glyph:FONT:CHAR": the outline of a character as closed curves, one a contour, in font units, y upwards.
/// FONT is a file, or the file name (with or without ending) or family name of a font in the usual font folders;
/// CHAR is one UTF-8 character or U+XXXX. Points are the on-curve nodes of the outline and the places where one of
/// its curves is extreme in x or y; points closer than half a font unit (the grid of outlines) to the one before are
/// left out, and so are contours of fewer than three points. Throws DataError, also for an empty glyph.
[[nodiscard]] Drawing glyph_drawing(std::string_view name);

/// Of the library that reads fonts; "unknown" if it cannot start.
[[nodiscard]] std::string freetype_version();

}  // namespace kappabench
