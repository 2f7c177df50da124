#pragma once

#include <vector>

#include "schemes/api/input.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// Parameter lengths h_i = |p_{i+1} - p_i|^alpha of the spans of an input, the closing span last if closed:
/// alpha 0 uniform, 1/2 centripetal (Lee 1989), 1 chord length. Consecutive points must not coincide.
[[nodiscard]] std::vector<double> span_lengths(const Input& input, double alpha);

/// The curve whose segment i runs from point i to the next one: every joint is at a point, and as smooth as said where
/// the path has a direction there and does not turn back (claim_at).
[[nodiscard]] Curve curve_through_joints(std::vector<SegmentPtr> segments, bool closed, Continuity smooth);

}  // namespace kappabench
