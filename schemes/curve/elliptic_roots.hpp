#pragma once

#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {

/// Of an elliptical arc, in closed form. The curvature keeps its sign; it is extreme where the speed is.
[[nodiscard]] SignChanges elliptic_sign_changes(const EllipticArcForm& form, bool of_slope);

/// Where the speed has its minima, inside.
[[nodiscard]] SignChanges elliptic_slow_places(const EllipticArcForm& form);

}  // namespace kappabench
