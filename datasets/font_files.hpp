#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "datasets/text.hpp"

namespace kappabench {

/// The folders where fonts usually are and that exist here: the user's own first.
[[nodiscard]] std::vector<std::filesystem::path> font_folders();

/// `font` itself if it is a file; otherwise the first font file, in order of folders and paths, whose name matches
/// (case, spaces and hyphens ignored), or failing that whose family, or family and style, matches; a regular style
/// wins over others. Throws DataError at `place` if there is none.
[[nodiscard]] std::filesystem::path find_font(std::string_view font, const Place& place);

}  // namespace kappabench
