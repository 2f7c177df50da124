#include "experiments/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/compare.hpp"
#include "experiments/ekappa_added_points.hpp"
#include "experiments/ekappa_applicability.hpp"
#include "experiments/ekappa_bases.hpp"
#include "experiments/ekappa_global_shape.hpp"
#include "experiments/ekappa_inflection.hpp"
#include "experiments/ekappa_iterations.hpp"
#include "experiments/ekappa_local_shape.hpp"
#include "experiments/ekappa_pinned.hpp"
#include "experiments/ekappa_timing.hpp"
#include "experiments/ekappa_trig_minima.hpp"
#include "experiments/fpc_convergence.hpp"
#include "experiments/fpc_features.hpp"
#include "experiments/fpc_gallery.hpp"
#include "experiments/fpc_inflection_h.hpp"
#include "experiments/fpc_locality.hpp"
#include "experiments/fpc_loop_size.hpp"
#include "experiments/fpc_loops.hpp"
#include "experiments/fpc_point_economy.hpp"
#include "experiments/intrinsic_control.hpp"
#include "experiments/intrinsic_example.hpp"
#include "experiments/intrinsic_g1.hpp"
#include "experiments/intrinsic_g1_to_g2.hpp"
#include "experiments/intrinsic_g2.hpp"
#include "experiments/intrinsic_timing.hpp"
#include "experiments/intrinsic_viable_region.hpp"
#include "experiments/pkappa_comparison.hpp"
#include "experiments/pkappa_construction.hpp"
#include "experiments/pkappa_continuity.hpp"
#include "experiments/pkappa_gallery.hpp"
#include "experiments/pkappa_locality.hpp"
#include "experiments/pkappa_order_and_symmetry.hpp"
#include "experiments/pkappa_solvers.hpp"
#include "experiments/pkappa_stages.hpp"
#include "experiments/pkappa_toy.hpp"
#include "experiments/pkappa_weights.hpp"
#include "experiments/scaling.hpp"

namespace kappabench {

std::span<const Experiment> all_experiments() {
  static const std::vector<Experiment> experiments{ekappa_added_points_experiment(),
                                                   ekappa_global_shape_experiment(),
                                                   ekappa_local_shape_experiment(),
                                                   ekappa_inflection_experiment(),
                                                   ekappa_bases_experiment(),
                                                   ekappa_pinned_experiment(),
                                                   ekappa_trig_minima_experiment(),
                                                   ekappa_iterations_experiment(),
                                                   ekappa_applicability_experiment(),
                                                   ekappa_timing_experiment(),
                                                   fpc_features_experiment(),
                                                   fpc_loops_experiment(),
                                                   fpc_convergence_experiment(),
                                                   fpc_loop_size_experiment(),
                                                   fpc_inflection_h_experiment(),
                                                   fpc_gallery_experiment(),
                                                   fpc_point_economy_experiment(),
                                                   fpc_locality_experiment(),
                                                   pkappa_toy_experiment(),
                                                   pkappa_construction_experiment(),
                                                   pkappa_stages_experiment(),
                                                   pkappa_weights_experiment(),
                                                   pkappa_gallery_experiment(),
                                                   pkappa_continuity_experiment(),
                                                   pkappa_comparison_experiment(),
                                                   pkappa_locality_experiment(),
                                                   pkappa_order_and_symmetry_experiment(),
                                                   pkappa_solvers_experiment(),
                                                   intrinsic_example_experiment(),
                                                   intrinsic_timing_experiment(),
                                                   intrinsic_g1_experiment(),
                                                   intrinsic_viable_region_experiment(),
                                                   intrinsic_g2_experiment(),
                                                   intrinsic_control_experiment(),
                                                   intrinsic_g1_to_g2_experiment(),
                                                   compare_experiment(),
                                                   scaling_experiment()};
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
