#pragma once

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// What may be said of the joint where `before` ends and `after` starts, when the construction makes it `smooth`
/// wherever both sides have a direction: `smooth`, but G0 where they have none (c' is nothing but rounding of the
/// coordinates) or opposite ones (the path turns straight back).
[[nodiscard]] Continuity claim_at(const Segment& before, const Segment& after, Continuity smooth);

/// What is true of a joint that nothing makes smooth but that may be: where a segment between the two has shrunk to a
/// point, or a method lets small kinks pass. `smooth` (G2, or G1 with equal |curvature|), else G1, else G0: the first
/// that the joint keeps (schemes/curve/joint.hpp).
[[nodiscard]] Continuity claim_found(const Segment& before, const Segment& after, Continuity smooth);

}  // namespace kappabench
