#pragma once

#include <functional>

#include "schemes/fpc/system.hpp"

namespace kappabench::fpc {

/// Sees every accepted point of a path; true means stop.
using PathVisitor = std::function<bool(const State& state, double softness)>;

/// Follows the path of the softened equations by arc length (`ArcLengthPath`) from `state`, a solution for `softness`,
/// at first towards less softness, for at most `most` linear solves. Returns their number.
long follow_path(const System& system, const State& state, double softness, long most, const PathVisitor& visit);

}  // namespace kappabench::fpc
