#pragma once

#include "schemes/api/edit.hpp"
#include "schemes/api/fit.hpp"
#include "schemes/api/input.hpp"
#include "schemes/curve/placement.hpp"

namespace kappabench {

/// The placement in the plane of the frame in which a drawing is best computed: its origin amid the points, its unit
/// about their extent. A coordinate keeps its origin while that is within 16 extents, and the unit stays 1 for extents
/// from 2^-30 to 2^30: what is of common size and place is computed as it is, bit for bit. The unit is a power of two,
/// and points so far out that the origin moves differ from it by less than a factor of two, so that placing the points
/// back is exact (Sterbenz' lemma). The identity for points that are not finite or all in one place.
[[nodiscard]] Placement frame_of(const Input& input);

/// The input, the edit, the fit with its curve, placed; prescribed curvatures with them.
[[nodiscard]] Input place(const Input& input, const Placement& placement);
[[nodiscard]] Edit place(const Edit& edit, const Placement& placement);
[[nodiscard]] Fit place(const Fit& fit, const Placement& placement);

}  // namespace kappabench
