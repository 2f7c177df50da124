#pragma once

#include "schemes/api/input.hpp"
#include "schemes/curve/placement.hpp"

namespace kappabench {

/// The placement in the plane of the frame in which a drawing is best computed: its origin amid the points, its unit
/// about their extent. A coordinate keeps its origin while that is within 16 extents, and the unit stays 1 for extents
/// from 2^-30 to 2^30: what is of common size and place is computed as it is, bit for bit. The unit is a power of two,
/// and points so far out that the origin moves differ from it by less than a factor of two, so that placing the points
/// back is exact (Sterbenz' lemma). The identity for points that are not finite or all in one place.
[[nodiscard]] Placement frame_of(const Input& input);

/// The input, placed; prescribed curvatures with it.
[[nodiscard]] Input place(const Input& input, const Placement& placement);

}  // namespace kappabench
