#pragma once

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <filesystem>
#include <memory>
#include <type_traits>

namespace kappabench {

// FreeType's handles with owners.

struct FreeTypeDeleter {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using FontLibrary = std::unique_ptr<std::remove_pointer_t<FT_Library>, FreeTypeDeleter>;
using FontFace = std::unique_ptr<std::remove_pointer_t<FT_Face>, FreeTypeDeleter>;

/// Null if FreeType cannot start.
[[nodiscard]] inline FontLibrary open_font_library() {
  FT_Library library = nullptr;
  return FontLibrary(FT_Init_FreeType(&library) == 0 ? library : nullptr);
}

/// The first face of a font file; null if it is none.
[[nodiscard]] inline FontFace open_font(const FontLibrary& library, const std::filesystem::path& file) {
  FT_Face face = nullptr;
  return FontFace(FT_New_Face(library.get(), file.c_str(), 0, &face) == 0 ? face : nullptr);
}

}  // namespace kappabench
