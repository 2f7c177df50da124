#include "experiments/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/compare.hpp"

namespace kappabench {

std::span<const Experiment> all_experiments() {
  static const std::vector<Experiment> experiments{compare_experiment()};
  return experiments;
}

const Experiment& find_experiment(std::string_view id) {
  const auto experiments = all_experiments();
  const auto found = std::ranges::find(experiments, id, &Experiment::id);
  if (found != experiments.end()) return *found;
  std::vector<std::string_view> ids;
  for (const Experiment& experiment : experiments) ids.push_back(experiment.id);
  throw std::invalid_argument(fmt::format("unknown experiment '{}'; known are {}", id, fmt::join(ids, ", ")));
}

}  // namespace kappabench
