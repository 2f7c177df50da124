#pragma once

#include "schemes/pkappa/chain.hpp"

namespace kappabench::pkappa {

/// Chord-length values of t: the share of its part of the polygon that a segment has before its point. Joints are taken
/// to lie halfway between points; where a joint is fixed or an end point, its position is used.
[[nodiscard]] std::vector<double> chord_parameters(const Chain& chain);

/// Sets the free joints and middle points to those of least bending of the control polygons, sum |c_{j+1} - 2 c_j +
/// c_{j-1}|^2, among all C1 or C2 chains that pass the points at the given t: one linear system, without preference for
/// either end. False if it is singular.
template <Continuity K>
[[nodiscard]] bool make_fair(Chain& chain);

/// Sets them so that control polygons run along the polygon of the points: joints halfway, straight there, each edge in
/// proportion to its own chord. Rough, but free of loops however uneven the chords are; t is 1/2. False as above.
template <Continuity K>
[[nodiscard]] bool make_polygonal(Chain& chain);

}  // namespace kappabench::pkappa
