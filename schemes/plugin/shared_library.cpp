#include "schemes/plugin/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

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

/// Ids stand on the command line, in names of files and in tables.
void check_id(const std::string& id) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789-";
  constexpr std::size_t longest = 64;
  if (id.empty() || id.size() > longest || id[0] < 'a' || id[0] > 'z' ||
      id.find_first_not_of(allowed) != std::string::npos)
    throw std::runtime_error(fmt::format(
        "registers a scheme '{}'; an id has lower-case letters, digits and hyphens, a letter first, at most {}",
        one_line(id), longest));
}

SchemePtr made(const Registry& registry, const std::string& id, const Parameters& parameters) {
  SchemePtr scheme = registry.create(id, {parameters.values().begin(), parameters.values().end()});
  if (scheme == nullptr) throw std::runtime_error(fmt::format("makes nothing of its scheme '{}'", id));
  return scheme;
}

/// What `work` throws, or what becomes of a process that does it; "" if it went well. Code of others runs here first:
/// what it breaks is a child's.
template <class Work>
std::string fault_in_child(Work work) {
  constexpr std::chrono::seconds longest_work{10};
  return trial(longest_work, [&work]() -> std::string {
    try {
      work();
    } catch (const std::exception& error) {
      return one_line(error.what());
    } catch (...) {
      return "throws what is no std::exception";
    }
    return "";
  });
}

/// Opens a library, and makes each of its schemes once.
void try_library(const fs::path& file) {
  Registry registry;
  register_schemes_of(file, registry);
  const std::vector<SchemeInfo> schemes = registry.list();
  if (schemes.empty()) throw std::runtime_error("registers no scheme; its register_schemes has to");
  for (const SchemeInfo& info : schemes) {
    check_id(info.id);
    static_cast<void>(made(registry, info.id, Parameters(info.parameters, {})));
  }
}

Fit failed(const Input& input, std::string message) {
  return {.input = input, .curve = std::nullopt, .report = {.outcome = Outcome::failed, .message = std::move(message)}};
}

/// The author's part, and what a Fit guarantees whatever that does.
template <class Solve>
Fit guarded(const Input& input, Solve solve) {
  try {
    Fit fit = solve();
    if (fit.report.outcome == Outcome::converged && !fit.curve)
      return failed(input, "the plugin says that it converged, and returns no curve");
    fit.input = input;
    return fit;
  } catch (const std::exception& error) {
    return failed(input, fmt::format("the plugin throws: {}", one_line(error.what())));
  } catch (...) {
    return failed(input, "the plugin throws what is no std::exception");
  }
}

std::string kind_of(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return "a folder; name the shared library in it, or a manifest *.toml";
  return fs::exists(file, ignored) ? "neither a shared library nor a manifest *.toml" : "no such file";
}

}  // namespace

/// A scheme of a library under the info that says which library: what it computes is the author's.
class LibraryScheme final : public Scheme {
 public:
  LibraryScheme(SchemeInfo info, SchemePtr of) : Scheme(std::move(info), of->parameters()), of_(std::move(of)) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override {
    return guarded(input, [&] { return of_->solve(input); });
  }
  [[nodiscard]] Fit resolve(const Fit& fit, const Edit& edit) const override {
    return guarded(apply(fit.input, edit), [&] { return of_->resolve(fit, edit); });
  }

  SchemePtr of_;
};

void load_shared_library(const fs::path& file, Registry& registry) {
  const fs::path absolute = fs::absolute(file);
  const auto refuse = [&file](std::string_view why) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
  };
  std::error_code ignored;
  if (!fs::is_regular_file(absolute, ignored)) refuse(kind_of(absolute));
  const std::string digest = digest_of_files(std::array{absolute});
  if (const std::string fault = fault_in_child([&] { try_library(absolute); }); !fault.empty()) refuse(fault);
  Registry own;
  register_schemes_of(absolute, own);
  const std::vector<SchemeInfo> known = registry.list();
  for (const SchemeInfo& info : own.list())
    if (std::ranges::find(known, info.id, &SchemeInfo::id) != known.end())
      throw std::invalid_argument(
          fmt::format("{}: there is a scheme '{}' already; choose another id", file.string(), info.id));
  for (SchemeInfo info : own.list()) {
    info.plugin = absolute.string();
    info.plugin_digest = digest;
    // With its defaults it was made when the library was tried.
    const auto make = [own, info](const Parameters& parameters) {
      const auto fault = [&] { return fault_in_child([&] { static_cast<void>(made(own, info.id, parameters)); }); };
      if (const std::string why = parameters.brief().empty() ? "" : fault(); !why.empty())
        throw std::invalid_argument(fmt::format("{}: {}", info.plugin, why));
      return std::make_shared<const LibraryScheme>(info, made(own, info.id, parameters));
    };
    registry.add(info, make);
  }
}

}  // namespace kappabench
