#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "datasets/datasets.hpp"
#include "experiments/program/scratch_folder.hpp"

namespace kappabench {

/// Writes a file there.
inline std::filesystem::path file_in(const ScratchFolder& folder, std::string_view name, std::string_view content) {
  const std::filesystem::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

/// What the DataError says that `action` throws; empty if it throws none.
template <class Action>
std::string refusal(const Action& action) {
  try {
    static_cast<void>(action());
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

}  // namespace kappabench
