#pragma once

#include <filesystem>

#include "schemes/api/registry.hpp"

namespace kappabench {

/// Adds the scheme that a manifest describes: a program in any language that is asked on its standard input and answers
/// on its standard output (README.md). Nothing is started before the first fit. Throws std::runtime_error with one
/// line, "my_spline.toml:7: ...", for a manifest that is no such description, and std::invalid_argument if the id is
/// taken.
void load_manifest(const std::filesystem::path& file, Registry& registry);

}  // namespace kappabench
