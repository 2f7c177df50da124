#pragma once

#include <filesystem>

#include "schemes/api/registry.hpp"

namespace kappabench {

/// Adds the schemes of a shared library built with kappabench_add_plugin (README.md). It is opened in a child process
/// first, for 10 s at most: one that crashes or hangs while it is loaded harms nobody. It stays open as long as the
/// process: what it registered, and what its constructors left behind, points into it. Throws std::runtime_error with
/// one line, "my_scheme.so: ...", for a file that is no such library, whose stamp differs (the first difference is
/// named, with both values), or that cannot be loaded, and std::invalid_argument if an id is taken.
void load_shared_library(const std::filesystem::path& file, Registry& registry);

}  // namespace kappabench
