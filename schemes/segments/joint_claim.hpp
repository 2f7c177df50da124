#pragma once

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// What may be said of the joint where `before` ends and `after` starts, when the construction makes it `smooth`
/// wherever both sides have a direction: `smooth`, but G0 where they have none (c' is nothing but rounding of the
/// coordinates) or opposite ones (the path turns straight back).
[[nodiscard]] Continuity claim_at(const Segment& before, const Segment& after, Continuity smooth);

/// The same where a segment between the two has shrunk to a point, so that nothing else makes them agree: `smooth`
/// (G2, or G1 with equal |curvature|) where |curvature| agrees to what solving and rounding explain, G1 where only the
/// directions do, and G0 where not even these.
[[nodiscard]] Continuity claim_across_point(const Segment& before, const Segment& after, Continuity smooth);

}  // namespace kappabench
