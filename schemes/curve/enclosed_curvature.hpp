#pragma once

#include <optional>

#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {

/// Extrema (`of_slope`) and sign changes of the curvature of what `enclosed_path` encloses, proved by interval
/// arithmetic. What is enclosed is a positive multiple of kappa or of d kappa / dt, and zero within a part in 2^40 of
/// its terms. nullopt where that does not decide: on curves that are straight or circular up to rounding.
[[nodiscard]] std::optional<SignChanges> enclosed_sign_changes(const Segment& segment, bool of_slope);

/// Whether interval arithmetic proves that the speed stays above `least`.
[[nodiscard]] bool speed_stays_above(const Segment& segment, double least);

}  // namespace kappabench
