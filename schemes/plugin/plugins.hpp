#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "schemes/api/registry.hpp"

namespace kappabench {

/// A file of schemes from outside that brought none, and why, in one line.
struct PluginFailure {
  std::filesystem::path file;
  std::string why;
};

/// Adds the schemes of each file to the registry: a manifest `*.toml` of an external program (manifest.hpp), or a
/// shared library (shared_library.hpp). A file that cannot be used takes nothing else with it: it is in the result.
[[nodiscard]] std::vector<PluginFailure> load_plugins(std::span<const std::filesystem::path> files, Registry& registry);

}  // namespace kappabench
