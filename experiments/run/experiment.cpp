#include "experiments/run/experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ranges>
#include <stdexcept>

namespace kappabench {

const Experiment& find_experiment(std::string_view id) {
  const auto experiments = all_experiments();
  const auto found = std::ranges::find(experiments, id, &Experiment::id);
  if (found != experiments.end()) return *found;
  throw std::invalid_argument(fmt::format("unknown experiment '{}'; known are {}", id,
                                          fmt::join(experiments | std::views::transform(&Experiment::id), ", ")));
}

}  // namespace kappabench
