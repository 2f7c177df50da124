#include "schemes/plugin/plugins.hpp"

#include <exception>

#include "schemes/plugin/manifest.hpp"
#include "schemes/plugin/shared_library.hpp"

namespace kappabench {

std::vector<PluginFailure> load_plugins(std::span<const std::filesystem::path> files, Registry& registry) {
  std::vector<PluginFailure> failures;
  for (const std::filesystem::path& file : files) {
    try {
      file.extension() == ".toml" ? load_manifest(file, registry) : load_shared_library(file, registry);
    } catch (const std::exception& error) {
      failures.push_back({file, error.what()});
    }
  }
  return failures;
}

}  // namespace kappabench
