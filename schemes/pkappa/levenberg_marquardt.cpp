#include <algorithm>
#include <cmath>
#include <utility>

#include "schemes/pkappa/solver.hpp"
#include "schemes/pkappa/system.hpp"

namespace kappabench::pkappa {

/// Levenberg-Marquardt with the parabolas eliminated; every iterate interpolates. Where the decrease is small, the
/// second derivatives of the constraints and joints count as well, for the last digits.
template <Continuity K>
Minimum minimise_lm(JointChain& chain, const QuadratureRule& rule, const MinimiseOptions& options) {
  ChainSystem<K> here(rule, options.weights), there(rule, options.weights);
  typename ChainSystem<K>::Step step;
  JointChain trial;
  Minimum minimum{.energy = here.linearise(chain, {})};
  if (!std::isfinite(minimum.energy)) return minimum;

  // Damping as Nielsen 1999 controls it.
  constexpr double most_damping = 1e12;
  double damping = options.first_damping, growth = 2.0;
  while (minimum.iterations < options.max_iterations && damping < most_damping) {
    ++minimum.iterations;
    const auto reject = [&] {
      damping *= growth;
      growth *= 2.0;
    };
    if (!here.step(chain, damping, step)) {
      reject();
      continue;
    }
    const double predicted = here.predicted_decrease(step, damping);
    minimum.decrease = minimum.energy > 0.0 ? std::abs(predicted) / minimum.energy : 0.0;
    if (!(minimum.decrease > options.tolerance)) {
      minimum.converged = true;
      break;
    }
    if (predicted < 0.0 || !advance<K>(chain, step, trial)) {
      reject();
      continue;
    }
    there.set_exact(minimum.decrease < 1e-3);
    const double energy = there.linearise(trial, step);
    const double gain = (minimum.energy - energy) / predicted;
    if (!(gain > 1e-4)) {
      reject();
      continue;
    }
    std::swap(chain, trial);
    std::swap(here, there);
    minimum.energy = energy;
    damping *= std::max(0.1, 1.0 - std::pow(2.0 * gain - 1.0, 3));
    growth = 2.0;
  }
  return minimum;
}

template Minimum minimise_lm<Continuity::c1>(JointChain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_lm<Continuity::g1>(JointChain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_lm<Continuity::c2>(JointChain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_lm<Continuity::g2>(JointChain&, const QuadratureRule&, const MinimiseOptions&);

}  // namespace kappabench::pkappa
