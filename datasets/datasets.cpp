#include "datasets/datasets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <span>
#include <utility>

#include "datasets/analytic.hpp"
#include "datasets/glyph.hpp"
#include "datasets/random_points.hpp"
#include "datasets/readers.hpp"
#include "datasets/text.hpp"

namespace kappabench {
namespace {

namespace fs = std::filesystem;

/// The files of a folder with one of the endings, sorted by name.
std::vector<fs::path> files_in(const fs::path& folder, std::span<const std::string_view> endings) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    const bool known = std::ranges::find(endings, at->path().extension().string()) != endings.end();
    std::error_code ignored;
    if (known && !at->is_directory(ignored)) files.push_back(at->path());
  }
  if (error) refuse({folder.string(), 0}, "this folder cannot be read", error.message());
  // By id: the ending would put "a-b.txt" before "a.txt".
  std::ranges::sort(files, {}, [](const fs::path& file) { return std::pair(file.stem(), file.extension()); });
  return files;
}

std::vector<Drawing> read_all(const std::vector<fs::path>& files) {
  std::vector<Drawing> drawings(files.size());
  std::ranges::transform(files, drawings.begin(), read_drawing);
  return drawings;
}

std::vector<fs::path> builtin_files() {
  constexpr std::array<std::string_view, 1> endings{".txt"};
  return files_in(builtin_folder(), endings);
}

std::vector<Drawing> read_folder(const fs::path& folder) {
  constexpr std::array<std::string_view, 4> endings{".txt", ".pts", ".csv", ".toml"};
  const std::vector<fs::path> files = files_in(folder, endings);
  if (files.empty()) {
    refuse({folder.string(), 0}, "no points in this folder", "files ending in .txt, .pts, .csv or .toml are read");
  }
  return read_all(files);
}

/// Levenshtein's distance: how many characters to insert, erase or replace.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

[[noreturn]] void refuse_unknown(std::string_view name) {
  std::string near;
  for (const fs::path& file : builtin_files()) {
    const std::string id = file.stem().string();
    if (edit_distance(name, id) <= 2 || (name.size() >= 3 && id.find(name) != id.npos)) {
      near += fmt::format("{}{}", near.empty() ? "did you mean " : " or ", id);
    }
  }
  refuse({in_quotes(name), 0}, "no built-in drawing, file or folder has this name",
         fmt::format("{}{}`kappabench list datasets` shows the drawings", near, near.empty() ? "" : "? "));
}

}  // namespace

Drawing read_drawing(const fs::path& file) {
  const std::string text = read_text(file);
  const std::string source = name_for_messages(file);
  const std::string ending = file.extension().string();
  Drawing drawing = ending == ".pts"    ? parse_pts(text, source)
                    : ending == ".csv"  ? parse_csv(text, source)
                    : ending == ".toml" ? parse_toml(text, source)
                                        : parse_plain(text, source);
  drawing.id = file == "-" ? "stdin" : file.stem().string();
  return drawing;
}

std::vector<Drawing> open_drawings(std::string_view name) {
  if (name == "-") return {read_drawing("-")};
  if (name.starts_with("glyph:")) return {glyph_drawing(name)};
  if (name.starts_with("random:")) return random_drawings(name);
  if (name.starts_with("analytic:")) return {analytic_drawing(name)};
  std::error_code error;
  const fs::path builtin = builtin_folder() / (std::string(name) + ".txt");
  if (name.find('/') == name.npos && fs::is_regular_file(builtin, error)) return {read_drawing(builtin)};
  const fs::path path(name);
  if (fs::is_directory(path, error)) return read_folder(path);
  if (fs::exists(path, error)) return {read_drawing(path)};
  refuse_unknown(name);
}

std::vector<Drawing> builtin_drawings() { return read_all(builtin_files()); }

fs::path builtin_folder() {
  if (const char* folder = std::getenv("KAPPABENCH_DATASETS"); folder != nullptr && *folder != '\0') return folder;
  return KAPPABENCH_POINTS_FOLDER;
}

}  // namespace kappabench
