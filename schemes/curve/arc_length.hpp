#pragma once

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// Length of `segment` between parameters t0 <= t1, by adaptive Gauss-Kronrod quadrature to a relative
/// `accuracy`. Reaches it on smooth segments; at a cusp it stops after 10 bisections.
[[nodiscard]] double arc_length(const Segment& segment, double t0, double t1, double accuracy = 1e-12);

/// Length of the whole curve.
[[nodiscard]] double arc_length(const Curve& curve, double accuracy = 1e-12);

}  // namespace kappabench
