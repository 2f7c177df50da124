#pragma once

#include <functional>

#include "schemes/kappa/system.hpp"

namespace kappabench::kappa {

/// Sees every accepted point of a path; true means stop.
using PathVisitor = std::function<bool(const State& state, const Values& values, double softness)>;

/// Follows the path of the softened equations by arc length (`ArcLengthPath`) from `state`, a solution of `setting`, at
/// first towards less softness if `down`, for at most `most` linear solves. Returns their number.
long follow_path(const System& system, const State& state, const Setting& setting, bool down, long most,
                 const PathVisitor& visit);

}  // namespace kappabench::kappa
