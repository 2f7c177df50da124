#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

#include "experiments/run/cell.hpp"

namespace kappabench {

struct WorkerOptions {
  int processes = 1;     ///< how many jobs run at once
  double timeout = 0.0;  ///< seconds a job may take; 0: any
  /// Where finished cells are kept, one file each, named by their key. It must exist.
  std::filesystem::path folder;
};

/// Computes every job in a child process of its own and leaves its cell in `<folder>/<key>.h5`. A job whose file is
/// there already is not computed again. A crash or a time-out is a cell too (outcome `crashed` or `timed_out`), and
/// takes no other job with it. Results depend neither on the number of processes nor on the order.
/// `finished` is called in this process after each job. Throws std::runtime_error when cells cannot be written.
void compute_cells(std::span<const CellJob> jobs, const WorkerOptions& options,
                   const std::function<void(const CellJob&)>& finished);

/// `<folder>/<key>.h5`.
[[nodiscard]] std::filesystem::path cell_file(const std::filesystem::path& folder, const CellJob& job);

}  // namespace kappabench
