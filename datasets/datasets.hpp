#pragma once

#include <filesystem>
#include <span>
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

/// The built-in drawings, sorted by id: those inside the program, or all of $KAPPABENCH_DATASETS, a folder of *.txt.
[[nodiscard]] std::vector<Drawing> builtin_drawings();

/// What is wrong with the drawings inside the program, one line; empty if nothing. Two must not have one id, and each
/// says its title, source, licence and units.
[[nodiscard]] std::string fault_of(std::span<const Drawing> drawings);

}  // namespace kappabench
