#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "datasets/random_points.hpp"

namespace kappabench::chen {

/// Random points whose types are drawn uniformly and independently from `types`; the ends of an open curve have none.
/// Depends on its arguments alone.
[[nodiscard]] Input typed_random_input(RandomKind kind, int n, std::uint64_t seed, bool closed,
                                       const std::vector<PointType>& types);

/// Number `index` of a sequence of such inputs with all four types: kinds of points by turns, 4 to 12 points, closed
/// or open; `seed` selects the sequence.
[[nodiscard]] Input typed_random_input(std::uint64_t seed, std::uint64_t index);

/// The first `count` of them, for the study `name`.
[[nodiscard]] Drawing typed_random_inputs(std::string_view name, std::uint64_t seed, int count);
/// Is it the id of such a drawing?
[[nodiscard]] inline bool is_random(std::string_view id) { return id.starts_with("random typed inputs"); }

}  // namespace kappabench::chen
