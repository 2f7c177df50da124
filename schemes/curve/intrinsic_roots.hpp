#pragma once

#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {

/// Sign changes of d kappa / dt (`of_slope`) or of kappa where curvature is given as a function of arc length: see
/// curvature_extrema and inflections, which call these.
[[nodiscard]] SignChanges clothoid_sign_changes(const ClothoidForm& form, bool of_slope);
[[nodiscard]] SignChanges intrinsic_sign_changes(const IntrinsicForm& form, bool of_slope);

}  // namespace kappabench
