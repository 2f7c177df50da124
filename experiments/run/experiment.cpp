#include "experiments/run/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "schemes/api/known_words.hpp"

namespace kappabench {

const Experiment& find_experiment(std::string_view id) {
  const auto experiments = all_experiments();
  const auto found = std::ranges::find(experiments, id, &Experiment::id);
  if (found != experiments.end()) return *found;
  std::vector<std::string> ids(experiments.size());
  std::ranges::transform(experiments, ids.begin(), &Experiment::id);
  throw std::invalid_argument(fmt::format("unknown experiment '{}'; {}", id, known_words(id, ids)));
}

}  // namespace kappabench
