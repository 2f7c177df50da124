#pragma once

#include <vector>

#include "schemes/api/fit.hpp"

namespace kappabench::wang {

/// The energies of Section 4 on finished curves.

/// The node inside every segment.
[[nodiscard]] std::vector<Node> inner_nodes(const Curve& curve);

/// E_p of every segment, 1/length: Eq. (3) for the best parabola with its vertex at the segment's point. Infinite at a
/// cusp.
[[nodiscard]] std::vector<double> parabola_energies(const Curve& curve);

/// Their mean; NaN for a fit that is not solved.
[[nodiscard]] double mean_energy_of(const Fit& fit);

/// What stage 1 minimises with weights 0.1, summed over the segments (Eqs. (3) to (6)), with `unit` as the length 1.
[[nodiscard]] double first_stage_energy(const Curve& curve, double unit);

/// What stage 2 minimises, each segment with the mean of the two chords at its point as the length 1; mean over the
/// segments.
[[nodiscard]] double mean_own_energy(const Curve& curve, const Input& input);

}  // namespace kappabench::wang
