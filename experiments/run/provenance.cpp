#include "experiments/run/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>
#include <toml++/toml.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>

#include "datasets/glyph.hpp"
#include "kappabench_commit.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

/// What follows `key` and the separator in the first such line of a file.
std::string line_of(const char* file, std::string_view key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t from = line.find_first_not_of(" \"", line.find(separator) + 1);
    const std::size_t to = line.find_last_not_of(" \"");
    if (from != std::string::npos && from <= to) return line.substr(from, to - from + 1);
  }
  return "unknown";
}

/// Distribution and kernel, without the machine's name.
std::string operating_system() {
  utsname kernel{};
  if (::uname(&kernel) != 0) return line_of("/etc/os-release", "PRETTY_NAME", '=');
  return fmt::format("{}, {} {} {}", line_of("/etc/os-release", "PRETTY_NAME", '='), kernel.sysname, kernel.release,
                     kernel.machine);
}

/// The arguments of this process, those that a shell would split or read otherwise in quotes.
std::string command_line() {
  std::ifstream arguments("/proc/self/cmdline", std::ios::binary);
  std::string command;
  for (std::string argument; std::getline(arguments, argument, '\0');) {
    if (!command.empty()) command += ' ';
    const bool plain = !argument.empty() && argument.find_first_of(" \t\n'\"\\$`*?;&|<>()[]{}#~!") == std::string::npos;
    if (plain) {
      command += argument;
      continue;
    }
    command += '\'';
    for (const char c : argument) command += c == '\'' ? std::string("'\\''") : std::string(1, c);
    command += '\'';
  }
  return command.empty() ? "unknown" : command;
}

std::string version(int major, int minor, int patch) { return fmt::format("{}.{}.{}", major, minor, patch); }

}  // namespace

std::map<std::string, std::string> provenance(const Registry& registry) {
  std::map<std::string, std::string> all{
      {"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
      {"command", command_line()},
      {"commit", KAPPABENCH_COMMIT},
      {"dirty", KAPPABENCH_DIRTY},
      {"compiler", KAPPABENCH_COMPILER},
      {"flags", KAPPABENCH_FLAGS},
      {"os", operating_system()},
      {"cpu", line_of("/proc/cpuinfo", "model name", ':')},
      {"threads", fmt::format("{}", std::thread::hardware_concurrency())},
      {"c_library", fmt::format("glibc {}", ::gnu_get_libc_version())},
      {"eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"boost", version(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"fmt", version(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"cli11", CLI11_VERSION},
      {"nlohmann_json", version(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"tomlplusplus", version(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"google_benchmark", KAPPABENCH_BENCHMARK},
      {"hdf5", store::hdf5_version()},
      {"freetype", freetype_version()}};
  for (const SchemeInfo& scheme : registry.list()) {
    all.insert(scheme.libraries.begin(), scheme.libraries.end());
    if (!scheme.plugin.empty())
      all.emplace("plugin_" + scheme.id, fmt::format("{}, digest {}", scheme.plugin, scheme.plugin_digest));
  }
  return all;
}

std::string version_text() {
  const bool changed = std::string_view(KAPPABENCH_DIRTY) == "true";
  return fmt::format("kappabench {}, commit {:.12}{}", KAPPABENCH_VERSION, KAPPABENCH_COMMIT,
                     changed ? " with changes" : "");
}

}  // namespace kappabench
