#include "datasets/font_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "datasets/freetype.hpp"

namespace kappabench {
namespace {

namespace fs = std::filesystem;

/// Lower case without spaces, hyphens and underscores: "DejaVu Sans" is "dejavusans".
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' && c != '-' && c != '_') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

std::vector<fs::path> font_files_in(const fs::path& folder) {
  constexpr std::array<std::string_view, 7> endings{".ttf", ".otf", ".ttc", ".otc", ".pfb", ".pfa", ".woff"};
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (std::ranges::find(endings, plain(at->path().extension().string())) != endings.end())
      files.push_back(at->path());
  }
  std::ranges::sort(files);
  return files;
}

/// 0: no match; 1: the family; 2: the family in its regular style; 3: family and style.
int family_match(const FontFace& face, const std::string& wanted) {
  const std::string family = plain(face->family_name != nullptr ? face->family_name : "");
  const std::string style = plain(face->style_name != nullptr ? face->style_name : "");
  if (family + style == wanted) return 3;
  if (family != wanted) return 0;
  return style == "regular" || style == "book" || style == "roman" ? 2 : 1;
}

}  // namespace

std::vector<fs::path> font_folders() {
  std::vector<fs::path> folders;
  if (const char* home = std::getenv("HOME")) {
    folders.push_back(fs::path(home) / ".fonts");
    folders.push_back(fs::path(home) / ".local/share/fonts");
    folders.push_back(fs::path(home) / "Library/Fonts");
  }
  for (const char* folder : {"/usr/local/share/fonts", "/usr/share/fonts", "/Library/Fonts", "/System/Library/Fonts"}) {
    folders.emplace_back(folder);
  }
  std::erase_if(folders, [](const fs::path& folder) {
    std::error_code error;
    return !fs::is_directory(folder, error);
  });
  return folders;
}

fs::path find_font(std::string_view font, const Place& place) {
  std::error_code error;
  if (fs::is_regular_file(fs::path(font), error)) return font;

  std::vector<fs::path> files;
  for (const fs::path& folder : font_folders()) std::ranges::copy(font_files_in(folder), std::back_inserter(files));
  const std::string wanted = plain(font);
  for (const fs::path& file : files) {
    if (plain(file.stem().string()) == wanted || plain(file.filename().string()) == wanted) return file;
  }
  const FontLibrary library = open_font_library();
  fs::path best;
  int best_match = 0;
  for (const fs::path& file : library ? files : std::vector<fs::path>()) {
    const FontFace face = open_font(library, file);
    const int match = face ? family_match(face, wanted) : 0;
    if (match > best_match) {
      best = file;
      best_match = match;
    }
  }
  if (best_match == 0) {
    refuse(place, fmt::format("no font {}", in_quotes(font)),
           "name a font file, or a family or file name of a font in the usual folders");
  }
  return best;
}

}  // namespace kappabench
