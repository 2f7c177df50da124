#pragma once

#include "experiments/program/progress_bar.hpp"
#include "experiments/run/runner.hpp"

namespace kappabench {

/// `run` with a bar on the terminal.
[[nodiscard]] inline RunSummary run_with_bar(const Registry& registry, const Plan& plan, RunOptions options) {
  ProgressBar bar("computing");
  options.progress = bar.callback();
  return run(registry, plan, options);
}

}  // namespace kappabench
