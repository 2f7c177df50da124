#pragma once

#include <map>
#include <string>

#include "schemes/api/scheme.hpp"
#include "schemes/kappa/cascade.hpp"
#include "schemes/kappa/family.hpp"

namespace kappabench::kappa {

/// A curve and what there is to count on it: nodes by their marks (marks.hpp), and "s_joints".
struct Assembled {
  Curve curve;
  std::map<std::string, long> counters;
};

/// The curve of a state: one segment for each segment of the chain, except those that have shrunk to a point at an
/// inflection. `setting` says which points are pinned.
[[nodiscard]] Assembled assemble(const Input& input, SegmentKind kind, const ChordChain& chain, const State& state,
                                 const Setting& setting);

}  // namespace kappabench::kappa
