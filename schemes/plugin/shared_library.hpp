#pragma once

#include <filesystem>

#include "schemes/api/registry.hpp"

namespace kappabench {

/// Adds the schemes of a shared library built with kappabench_add_plugin (README.md). The library is opened in a child
/// process first, which tells what schemes there are: one that crashes or hangs while it is loaded harms nobody. This
/// process opens it when the first of its schemes is made. Throws std::runtime_error with one line for a library that
/// cannot be opened, has another stamp or no entry point, and std::invalid_argument if an id is taken.
void load_shared_library(const std::filesystem::path& file, Registry& registry);

}  // namespace kappabench
