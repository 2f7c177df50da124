#pragma once

#include <map>
#include <string>

#include "schemes/api/input.hpp"
#include "schemes/curve/curve.hpp"
#include "schemes/fpc/cubic_chain.hpp"

namespace kappabench::fpc {

struct Assembled {
  Curve curve;
  std::map<std::string, long> counters;  ///< "s_joints", "at_inflection"
};

/// The curve of a state: a cubic Bézier segment for each point. Joints are claimed G2 where the curvature keeps its
/// sign and G1 with equal |kappa| where it changes. A segment that has shrunk to its point is left out; the point's
/// node is then the joint of its neighbours.
[[nodiscard]] Assembled assemble(const Input& input, const CubicChain& chain, const State& state);

}  // namespace kappabench::fpc
