#include "experiments/run/provenance.hpp"

#include <fmt/format.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "kappabench_commit.hpp"

namespace kappabench {

namespace {

std::string processor() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

}  // namespace

std::map<std::string, std::string> provenance() {
  return {{"commit", KAPPABENCH_COMMIT},
          {"dirty", KAPPABENCH_DIRTY},
          {"compiler", KAPPABENCH_COMPILER},
          {"flags", KAPPABENCH_FLAGS},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"boost", BOOST_LIB_VERSION},
          {"fmt", fmt::format("{}", FMT_VERSION)},
          {"cli11", CLI11_VERSION},
          {"nlohmann_json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                        NLOHMANN_JSON_VERSION_PATCH)},
          {"cpu", processor()},
          {"threads", fmt::format("{}", std::thread::hardware_concurrency())}};
}

}  // namespace kappabench
