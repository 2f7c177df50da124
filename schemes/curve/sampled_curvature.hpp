#pragma once

#include <vector>

#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {

/// What is known of a segment that can only be evaluated, or of which nothing could be proved: from 257 parameters.
/// Sign changes are refined by bisection.
[[nodiscard]] SignChanges sampled_sign_changes(const Segment& segment, bool of_slope);

/// Local minima of the sampled speed, refined by bisection of the sign of c' . c''.
[[nodiscard]] std::vector<double> sampled_slow_places(const Segment& segment);

/// The mean speed over t, to a factor of 4 for polynomials of degree up to 5 and trigonometric segments: their speed
/// varies little between samples (Markov's inequality).
[[nodiscard]] double mean_speed(const Segment& segment);

}  // namespace kappabench
