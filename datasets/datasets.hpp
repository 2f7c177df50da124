#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/drawing.hpp"

namespace kappabench {

/// Data that cannot be read: one line with file:line, what is wrong and what would be right.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One file in any supported format, told apart by its ending: .pts, .csv, .toml, otherwise plain text.
/// "-" is plain text from standard input. Throws DataError.
[[nodiscard]] Drawing read_drawing(const std::filesystem::path& file);

/// Everything that a POINTS argument of the command line may name: the id of a built-in drawing, a file, a
/// folder of files, "-", "glyph:FONT:CHAR", "random:KIND:n=..,seed=..", "analytic:KIND:n=..,sampling=..". A built-in id
/// wins over a file of the same name ("./bird" is the file); of a folder every .txt, .pts, .csv and .toml is read,
/// sorted by name. Throws DataError.
[[nodiscard]] std::vector<Drawing> open_drawings(std::string_view name);

/// The built-in drawings, sorted by id.
[[nodiscard]] std::vector<Drawing> builtin_drawings();

/// Where the built-in drawings are: $KAPPABENCH_DATASETS, or the folder known at build time.
[[nodiscard]] std::filesystem::path builtin_folder();

}  // namespace kappabench
