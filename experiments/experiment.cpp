#include "experiments/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/compare.hpp"
#include "experiments/ekappa_bases.hpp"
#include "experiments/ekappa_inflection.hpp"
#include "experiments/ekappa_pinned.hpp"
#include "experiments/ekappa_trig_minima.hpp"
#include "experiments/ekappa_iterations.hpp"

namespace kappabench {

std::span<const Experiment> all_experiments() {
  static const std::vector<Experiment> experiments{ekappa_inflection_experiment(), ekappa_bases_experiment(), ekappa_pinned_experiment(),
                                                   ekappa_trig_minima_experiment(), ekappa_iterations_experiment(), compare_experiment()};
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
