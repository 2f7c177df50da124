#pragma once

#include <vector>

#include "metrics/metric.hpp"

namespace kappabench {

namespace column {
/// Farthest span that deviates by more than 10^-exponent of the displacement of a point by `percent` of the mean chord.
[[nodiscard]] Column locality_reach(int exponent, int percent);
[[nodiscard]] Column locality_support(int percent);
inline const Column locality_decay{"locality_decay", "1",
                                   "factor of influence from one span to the next, 1 % moves; NaN if too local"};
inline const Column locality_failed{"locality_failed", "1", "fraction of the moved inputs without a comparable curve"};
inline const Column locality_refit_deviation{"locality_refit_deviation", "1",
                                             "refit against cold fit: largest deviation over the mean chord"};
}  // namespace column

/// How far the effect of moving one point reaches. Spans (between consecutive nodes) are counted from the moved
/// point: the two beside it are at distance 1, the next two at distance 2, and so on.
struct LocalityProfile {
  double displacement;  ///< over the mean chord
  /// By distance, from 1: largest deviation of a span over the displacement, over all points and directions that were
  /// tried.
  std::vector<double> influence;
  int fits = 0;    ///< moved inputs that were fitted
  int failed = 0;  ///< of them, without a curve or with another order of nodes; these are left out of `influence`

  /// The largest distance whose influence is above `threshold`; 0 if none is.
  [[nodiscard]] int reach(double threshold) const;
};

/// Moves points by `displacement` mean chords in 8 directions (0, 45, ... degrees), one at a time, and fits from
/// scratch each time. All points of inputs of up to 60, otherwise 12 evenly chosen ones.
[[nodiscard]] LocalityProfile locality_profile(const Scheme& scheme, const Fit& fit, double displacement);

/// The factor by which influence falls from one distance to the next: least squares on its logarithm over
/// the distances where it is above 1e-10. NaN for fewer than three of them.
[[nodiscard]] double decay_per_span(const LocalityProfile& profile);

/// Reach at displacements of 1, 5 and 10 % and influences of 1e-2, 1e-3, 1e-6, support, decay, and refit against cold
/// fit.
[[nodiscard]] Metric locality_metric();

}  // namespace kappabench
