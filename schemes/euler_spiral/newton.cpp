#include "schemes/euler_spiral/newton.hpp"

#include <limits>
#include <utility>

#include "schemes/curve/joint.hpp"

namespace kappabench::euler_spiral {

bool Found::solved() const { return residual <= solver_accuracy; }

Found newton(System& system, Headings headings, double bend) {
  constexpr int most_steps = 60, most_halvings = 12;
  // Curvatures times chords are up to 8, and sums of 20 to 80 rounded terms.
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  Found at{std::move(headings), std::numeric_limits<double>::infinity(), 0};
  if (!system.evaluate(at.headings, bend)) return at;
  at.residual = system.residual();
  double squares = system.squares();
  Headings step, by_bend, trial(at.headings.size());
  while (at.residual > rounding && at.iterations < most_steps && system.solve(step, by_bend)) {
    ++at.iterations;
    bool fell = false;
    double factor = 1.0;
    for (int halvings = 0; halvings < most_halvings && !fell; ++halvings, factor *= 0.5) {
      for (std::size_t k = 0; k < trial.size(); ++k) trial[k] = at.headings[k] + factor * step[k];
      fell = system.evaluate(trial, bend) && system.squares() < squares;
    }
    if (!fell) break;
    std::swap(at.headings, trial);
    at.residual = system.residual();
    squares = system.squares();
  }
  return at;
}

}  // namespace kappabench::euler_spiral
