#pragma once

#include <filesystem>
#include <string_view>

#include "schemes/api/registry.hpp"
#include "schemes/plugin/process.hpp"

namespace kappabench {

/// An external program as a scheme.
struct Manifest {
  SchemeInfo info;
  Command command;
  double timeout = 20.0;  ///< seconds a fit may take
};

/// Reads a manifest (README.md) and the bytes of the files that it names. Throws std::runtime_error with one line,
/// "my_spline.toml:7: timeout: -1; a number of seconds above 0".
[[nodiscard]] Manifest read_manifest(const std::filesystem::path& file);

/// Adds the scheme that a manifest describes: a program in any language that is asked on its standard input and answers
/// on its standard output (README.md). Nothing is started before the first fit. Throws std::runtime_error with one
/// line, "my_spline.toml:7: ...", for a manifest that is no such description, and std::invalid_argument if the id is
/// taken.
void load_manifest(const std::filesystem::path& file, Registry& registry);

}  // namespace kappabench
