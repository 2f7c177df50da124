#pragma once

#include <optional>

#include "schemes/pkappa/joint_chain.hpp"

namespace kappabench::pkappa {

/// Starts that prefer neither end of a chain. Each takes a chain whose points and unfree joints are set, and gives that
/// problem with values for all that is free and boxes around its own t; nothing if its linear system is singular.

/// The control polygons of least bending, sum |c_{j+1} - 2 c_j + c_{j-1}|^2 over their squared units, among all C1 or
/// C2 chains that pass the points at t of the chord lengths.
template <Continuity K>
[[nodiscard]] std::optional<JointChain> fair_start(const JointChain& given);

/// Control polygons along the polygon of the points: joints halfway, straight there, each edge in proportion to its own
/// chord, t = 1/2. Rough, but free of loops however uneven the chords are.
template <Continuity K>
[[nodiscard]] std::optional<JointChain> polygonal_start(const JointChain& given);

}  // namespace kappabench::pkappa
