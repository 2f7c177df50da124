#pragma once

#include <string>

#include "schemes/api/input.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// The first thing that a curve misses of its own claims, in one line with place and both numbers; empty if it keeps
/// them: closed as the input is, finite, every point met at a node, every joint as continuous as it claims (miss_of).
/// Judged by what rounding of the coordinates explains. Looks at nodes and joints and at the middles of segments, no
/// further; linear, a few jets a joint.
[[nodiscard]] std::string unsoundness(const Curve& curve, const Input& input);

}  // namespace kappabench
