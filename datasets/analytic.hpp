#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "datasets/drawing.hpp"

namespace kappabench {

/// Curves whose true shape is known. Lengths are of order 1.
enum class AnalyticKind {
  circle,        ///< radius 1, closed
  ellipse,       ///< half axes 2 and 1, closed
  superellipse,  ///< |x/2|^4 + |y|^4 = 1, closed
  clothoid,      ///< curvature = arc length, from -2.5 to 2.5: an S, open
  log_spiral,    ///< r = 0.2 exp(0.2 angle), two turns, open
  sine,          ///< y = sin x over three half waves on each side of 0, open
  limacon        ///< r = 1 + 2 cos(angle): a loop within a loop, closed, crosses itself
};

/// How the points lie along the curve.
enum class Sampling {
  even,    ///< the same arc length apart; an open curve has both ends
  uneven,  ///< arc lengths apart that differ up to 20 times, log-uniformly
  noisy    ///< even, then each coordinate moved by a normal number of 2 % of the spacing
};

[[nodiscard]] const std::vector<AnalyticKind>& analytic_kinds();
[[nodiscard]] const std::vector<Sampling>& samplings();

/// "circle", "ellipse", "superellipse", "clothoid", "log-spiral", "sine", "limacon".
[[nodiscard]] std::string_view name(AnalyticKind kind);
/// "even", "uneven", "noisy".
[[nodiscard]] std::string_view name(Sampling sampling);

/// `n` >= 2 points of the curve, up to the noise exactly on it; their arc-length positions are good to about 1e-5 of
/// the spacing for moderate n. Reproducible like random_input. Throws std::invalid_argument if n < 2.
[[nodiscard]] Input analytic_input(AnalyticKind kind, int n, Sampling sampling, std::uint64_t seed);

/// "analytic:KIND[:n=12,sampling=even,seed=1]". Throws DataError.
[[nodiscard]] Drawing analytic_drawing(std::string_view name);

}  // namespace kappabench
