#include "schemes/plugin/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "schemes/plugin/digest.hpp"
#include "schemes/plugin/one_line.hpp"
#include "schemes/plugin/stamp.hpp"
#include "schemes/plugin/trial.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

using Entry = const char* (*)(const char* programs_stamp, void* registry);

/// "compiler=gcc-11, and this program has compiler=gcc-12": the first word in which the stamps differ.
std::string first_difference(const std::string& plugins, const std::string& ours) {
  std::istringstream theirs_in(plugins), ours_in(ours);
  std::string theirs, own;
  while (theirs_in >> theirs, ours_in >> own)
    if (theirs != own) break;
  return fmt::format("{}, and this program has {}", one_line(theirs.empty() ? "nothing" : theirs), own);
}

/// Never closed again.
Entry open_library(const fs::path& file) {
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    // The system's words begin with the path.
    std::string why = one_line(dlerror());
    if (why.starts_with(file.string() + ": ")) why.erase(0, file.string().size() + 2);
    throw std::runtime_error("cannot be loaded: " + why);
  }
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "kappabench_plugin"));
  if (entry == nullptr)
    throw std::runtime_error("is no plugin: it has no function kappabench_plugin; build it with kappabench_add_plugin");
  return entry;
}

/// What a trial of loading comes to, too: it throws what loading would throw.
void register_schemes_of(const fs::path& file, Registry& registry) {
  const Entry entry = open_library(file);
  const std::string ours = plugin_stamp();
  const std::string theirs = entry(ours.c_str(), nullptr);
  if (theirs != ours)
    throw std::runtime_error(
        fmt::format("was built for another program: it has {}; build it anew", first_difference(theirs, ours)));
  entry(ours.c_str(), &registry);
}

/// "" if it went well, else why not.
std::string fault_in_child(const fs::path& file) {
  const std::chrono::seconds longest_load{10};
  return trial(longest_load, [&file]() -> std::string {
    Registry registry;
    try {
      register_schemes_of(file, registry);
    } catch (const std::exception& error) {
      return error.what();
    }
    return registry.list().empty() ? "registers no scheme; its register_schemes has to" : "";
  });
}

}  // namespace

/// A scheme of a library under the info that says which library: what it computes is the author's.
class LibraryScheme final : public Scheme {
 public:
  LibraryScheme(SchemeInfo info, SchemePtr of) : Scheme(std::move(info), of->parameters()), of_(std::move(of)) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override { return of_->solve(input); }
  [[nodiscard]] Fit resolve(const Fit& fit, const Edit& edit) const override { return of_->resolve(fit, edit); }

  SchemePtr of_;
};

void load_shared_library(const fs::path& file, Registry& registry) {
  const fs::path absolute = fs::absolute(file);
  if (!fs::is_regular_file(absolute)) throw std::runtime_error(file.string() + ": no such file");
  if (const std::string fault = fault_in_child(absolute); !fault.empty())
    throw std::runtime_error(fmt::format("{}: {}", file.string(), fault));
  Registry own;
  register_schemes_of(absolute, own);
  const std::string digest = digest_of_files(std::array{absolute});
  for (SchemeInfo info : own.list()) {
    info.plugin = absolute.string();
    info.plugin_digest = digest;
    const auto make = [own, info](const Parameters& parameters) {
      const SchemePtr scheme = own.create(info.id, {parameters.values().begin(), parameters.values().end()});
      return std::make_shared<const LibraryScheme>(info, scheme);
    };
    registry.add(info, make);
  }
}

}  // namespace kappabench
