#pragma once

#include <cstdint>
#include <vector>

#include "datasets/random_points.hpp"

namespace kappabench::fpc {

/// Random points whose types are drawn uniformly and independently from `types`; the ends of an open curve have none.
/// Depends on its arguments alone.
[[nodiscard]] Input typed_random_input(RandomKind kind, int n, std::uint64_t seed, bool closed,
                                       const std::vector<PointType>& types);

/// Number `index` of a sequence of such inputs with all four types: kinds of points by turns, 4 to 12 points, closed
/// or open; `seed` selects the sequence.
[[nodiscard]] Input typed_random_input(std::uint64_t seed, std::uint64_t index);

}  // namespace kappabench::fpc
