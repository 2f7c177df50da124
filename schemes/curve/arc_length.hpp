#pragma once

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// Length of `segment` between parameters t0 <= t1 to a relative `accuracy`, by Boost.Math's adaptive Gauss-Kronrod
/// quadrature over its steady stretches, so that near and at cusps it is as good as elsewhere. NaN where the estimated
/// error stays above `accuracy` plus the rounding noise of the speed.
[[nodiscard]] double arc_length(const Segment& segment, double t0, double t1, double accuracy = 1e-12);

/// Length of the whole curve.
[[nodiscard]] double arc_length(const Curve& curve, double accuracy = 1e-12);

/// Relative rounding noise of the speed at `jet` (order 1), from coordinates that are large against the speed; at most
/// 1e-6. No quadrature gets below it.
[[nodiscard]] double speed_noise(const Jet& jet);

}  // namespace kappabench
