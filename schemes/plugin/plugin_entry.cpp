// The one door of a plugin, compiled into it by kappabench_add_plugin: with the compiler and the options of its author,
// which is what the stamp tells.
#include <string>
#include <string_view>

#include "schemes/api/registry.hpp"
#include "schemes/plugin/stamp.hpp"

/// The author's: adds the schemes to the registry.
void register_schemes(kappabench::Registry& registry);

extern "C" {

/// Returns the stamp of this plugin. If the program's is the same and there is a registry, adds the schemes to it.
__attribute__((visibility("default"))) const char* kappabench_plugin(const char* programs_stamp, void* registry) {
  static const std::string stamp = kappabench::plugin_stamp();
  if (registry != nullptr && std::string_view(programs_stamp) == stamp)
    register_schemes(*static_cast<kappabench::Registry*>(registry));
  return stamp.c_str();
}
}
