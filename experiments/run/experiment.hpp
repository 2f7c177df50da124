#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/cell.hpp"
#include "reports/store/model.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench {

/// What an experiment may use and what the user overrides. An empty list means the experiment's own choice.
struct Context {
  const Registry& registry;
  std::uint64_t seed = 1;
  std::vector<std::string> schemes{};   ///< "ekappa:a=0.8"
  std::vector<std::string> datasets{};  ///< anything open_drawings takes
  std::vector<std::string> metrics{};   ///< metric ids
};

/// A table or figure of a paper, or a study of ours: independent cells, then tables, figures and verdicts drawn from
/// the finished cells alone. `conclude` must be deterministic: merging shards calls it again.
struct Experiment {
  std::string id;  ///< "<paper>-<name>", or one word for studies across papers
  std::string title;
  std::string about;                  ///< what is shown, for readers of the report
  std::string paper{};                ///< reports/paper/<paper>.toml; empty for studies across papers
  std::vector<std::string> claims{};  ///< ids of the claims of `paper` that `conclude` judges
  std::function<std::vector<CellJob>(const Context&)> jobs;
  std::function<void(const Context&, store::ExperimentRecord&)> conclude;
};

/// Every experiment, in the order of the report.
[[nodiscard]] std::span<const Experiment> all_experiments();

/// Throws std::invalid_argument naming the known ids.
[[nodiscard]] const Experiment& find_experiment(std::string_view id);

}  // namespace kappabench
