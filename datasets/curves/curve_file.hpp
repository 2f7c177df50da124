#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "schemes/api/read_curve_json.hpp"

namespace kappabench {

/// A file of curves that were made elsewhere.
struct CurveFile {
  std::filesystem::path file;
  std::string digest;               ///< of all its bytes
  std::vector<CurveRecord> curves;  ///< of SVG: segments, and `closed` where the path says so
};

/// Curve JSON (schemes/api/CURVE_JSON.md) or SVG (README.md), told apart by how the file starts; "-" is standard input.
/// Throws DataError or std::invalid_argument, one line with the place in the file.
[[nodiscard]] CurveFile read_curve_file(const std::filesystem::path& file);

}  // namespace kappabench
