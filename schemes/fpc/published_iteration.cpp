#include "schemes/fpc/published_iteration.hpp"

#include <limits>

#include "schemes/fpc/condition.hpp"

namespace kappabench::fpc {

Published iterate_published(const CubicChain& chain, int most) {
  const System system(chain);
  Published result;
  Solution& solution = result.solution;
  solution.residual = std::numeric_limits<double>::infinity();
  std::vector<double> log_ratio(chain.joints(), 0.0);
  for (;;) {
    State state;
    result.singular = !system.solve_joints(log_ratio, state);
    if (result.singular) break;
    system.solve_weights(state);
    solution.state = std::move(state);
    solution.residual = residual_of(chain, solution.state, log_ratio);
    solution.trace.push_back(solution.residual);
    solution.converged = solution.residual <= accuracy;
    if (solution.converged || solution.effort.sweeps == most) break;
    ++solution.effort.sweeps;
    // Eq. (17): its denominator holds the old lambda once, by Eq. (16), so that lambda^2 = ideal^3 / old lambda, where
    // the ideal one would make the curvatures of these segments agree.
    const std::vector<double> ideal = system.log_ratios(solution.state);
    for (std::size_t k = 0; k < log_ratio.size(); ++k) log_ratio[k] = 1.5 * ideal[k] - 0.5 * log_ratio[k];
  }
  if (!solution.converged) result.singular = result.singular || joint_condition(chain, log_ratio) > singular_condition;
  solution.iterations = static_cast<double>(solution.effort.sweeps);
  return result;
}

}  // namespace kappabench::fpc
