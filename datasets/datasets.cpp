#include "datasets/datasets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "datasets/analytic.hpp"
#include "datasets/csv_dialect.hpp"
#include "datasets/glyph.hpp"
#include "datasets/random_points.hpp"
#include "datasets/readers.hpp"
#include "datasets/text.hpp"
#include "schemes/api/known_words.hpp"

namespace kappabench {

/// Name and text of each file of points/; the build writes it (inside.cmake).
std::span<const std::pair<std::string_view, std::string_view>> points_inside();

namespace {

namespace fs = std::filesystem;

/// ".csv", also of a file "POINTS.CSV".
std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return ending;
}

/// The files of a folder with one of the endings, sorted by name.
std::vector<fs::path> files_in(const fs::path& folder, std::span<const std::string_view> endings) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    const bool known = std::ranges::find(endings, ending_of(at->path())) != endings.end();
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

/// The folder that stands in for the drawings inside the program; empty if none does.
fs::path users_folder() {
  const char* folder = std::getenv("KAPPABENCH_DATASETS");
  return folder == nullptr ? "" : folder;
}

std::vector<fs::path> users_files() {
  constexpr std::array<std::string_view, 1> endings{".txt"};
  return files_in(users_folder(), endings);
}

std::string id_of(std::string_view file) { return fs::path(file).stem().string(); }

Drawing drawing_inside(std::string_view file, std::string_view text) {
  Drawing drawing = parse_plain(text, file);
  drawing.id = id_of(file);
  return drawing;
}

std::vector<std::string> builtin_ids() {
  std::vector<std::string> ids;
  if (users_folder().empty()) {
    for (const auto& [file, text] : points_inside()) ids.push_back(id_of(file));
  } else {
    for (const fs::path& file : users_files()) ids.push_back(file.stem().string());
  }
  return ids;
}

std::optional<Drawing> find_builtin(std::string_view id) {
  if (!users_folder().empty()) {
    const fs::path file = users_folder() / fmt::format("{}.txt", id);
    std::error_code error;
    const bool there = id.find('/') == id.npos && fs::is_regular_file(file, error);
    return there ? std::optional(read_drawing(file)) : std::nullopt;
  }
  const auto files = points_inside();
  const auto found = std::ranges::find_if(files, [&](const auto& file) { return id_of(file.first) == id; });
  return found == files.end() ? std::nullopt : std::optional(drawing_inside(found->first, found->second));
}

std::vector<Drawing> read_folder(const fs::path& folder) {
  constexpr std::array<std::string_view, 4> endings{".txt", ".pts", ".csv", ".toml"};
  const std::vector<fs::path> files = files_in(folder, endings);
  if (files.empty()) {
    refuse({folder.string(), 0}, "no points in this folder", "files ending in .txt, .pts, .csv or .toml are read");
  }
  return read_all(files);
}

[[noreturn]] void refuse_unknown(std::string_view name) {
  const std::vector<std::string> near = nearest_words(name, builtin_ids());
  const std::string hint = near.empty() ? "" : fmt::format("did you mean {}? ", fmt::join(near, " or "));
  refuse({in_quotes(name), 0}, "no built-in drawing, file or folder has this name",
         hint + "`kappabench list datasets` shows the drawings");
}

}  // namespace

Drawing read_drawing(const fs::path& file) {
  const std::string text = read_text(file);
  const std::string source = name_for_messages(file);
  const std::string ending = ending_of(file);
  const bool csv = ending == ".csv" || (ending != ".pts" && ending != ".toml" && looks_like_csv(text));
  Drawing drawing = ending == ".pts"    ? parse_pts(text, source)
                    : csv               ? parse_csv(text, source)
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
  if (std::optional<Drawing> builtin = find_builtin(name)) return {*std::move(builtin)};
  const fs::path path(name);
  std::error_code error;
  if (fs::is_directory(path, error)) return read_folder(path);
  if (fs::exists(path, error)) return {read_drawing(path)};
  refuse_unknown(name);
}

std::vector<Drawing> builtin_drawings() {
  if (!users_folder().empty()) return read_all(users_files());
  std::vector<Drawing> drawings;
  for (const auto& [file, text] : points_inside()) drawings.push_back(drawing_inside(file, text));
  std::ranges::sort(drawings, {}, &Drawing::id);
  return drawings;
}

std::string fault_of(std::span<const Drawing> drawings) {
  std::set<std::string_view> ids;
  for (const Drawing& drawing : drawings) {
    if (!ids.insert(drawing.id).second) return fmt::format("two built-in drawings have the id '{}'", drawing.id);
    const std::array<std::pair<std::string_view, const std::string*>, 4> needed{{{"title", &drawing.title},
                                                                                 {"source", &drawing.source},
                                                                                 {"licence", &drawing.licence},
                                                                                 {"units", &drawing.units}}};
    for (const auto& [key, value] : needed)
      if (value->empty())
        return fmt::format("datasets/points/{}.txt: no {}; begin with a line '# {}: ...'", drawing.id, key, key);
  }
  return "";
}

}  // namespace kappabench
