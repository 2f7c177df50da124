#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kappabench {

/// Which experiments to run and what to run them on; see experiments/plans/. An empty list leaves the choice to the
/// experiment.
struct PlannedExperiment {
  std::string id;
  std::vector<std::string> schemes{};
  std::vector<std::string> datasets{};
  std::vector<std::string> metrics{};
};

struct Plan {
  std::uint64_t seed = 1;
  std::vector<PlannedExperiment> experiments{};
};

/// Throws std::invalid_argument: "file:line: what; what would be right".
[[nodiscard]] Plan read_plan(const std::filesystem::path& file);
[[nodiscard]] Plan parse_plan(std::string_view text, std::string_view source_name);

/// The plan as TOML that parse_plan reads back: part of every results file.
[[nodiscard]] std::string to_toml(const Plan& plan);

}  // namespace kappabench
