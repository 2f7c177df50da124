#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/plan.hpp"
#include "reports/store/model.hpp"
#include "schemes/api/registry.hpp"

namespace kappabench {

struct RunOptions {
  std::filesystem::path results;  ///< the HDF5 file to write
  int processes = 1;
  double timeout = 0.0;  ///< seconds a cell; 0: any
  bool resume = false;   ///< keep the cells of an earlier run of `results` that are still valid
  int shard = 1;         ///< this run computes every `shards`-th cell, starting with the `shard`-th
  int shards = 1;
  /// Cells from elsewhere that stand beside those of an experiment, by its id: in its tables and figures like its own.
  std::map<std::string, std::vector<store::CellRecord>> beside{};
  /// Called after every cell: how many of how many are done, and what was done last.
  std::function<void(std::size_t done, std::size_t total, std::string_view last)> progress{};
};

struct RunSummary {
  store::Results results;
  int lost = 0;  ///< cells that crashed, timed out or failed
};

/// Runs the plan and writes the results file: to a temporary name, then renamed. Finished cells are kept beside it
/// in `<results>.cells/` until then, so that a killed run loses nothing: `resume` takes them up.
/// Throws std::invalid_argument for a plan that names what is not there, std::runtime_error when writing fails.
[[nodiscard]] RunSummary run(const Registry& registry, const Plan& plan, const RunOptions& options);

/// Joins the cells of shards of one plan and concludes its experiments as a single run would have done. Throws
/// std::invalid_argument when the files are of different plans or cells are missing.
[[nodiscard]] store::Results merge(const Registry& registry, const std::vector<std::filesystem::path>& shards);

}  // namespace kappabench
