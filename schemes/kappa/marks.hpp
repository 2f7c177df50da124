#pragma once

#include <string_view>
#include <vector>

#include "schemes/api/scheme.hpp"
#include "schemes/kappa/family.hpp"

/// What the kappa family says of a node; the counters of these names count them.
namespace kappabench::kappa::marks {

inline constexpr std::string_view pinned = "pinned";
inline constexpr std::string_view at_inflection = "at_inflection";
inline constexpr std::string_view curvature_minimum = "curvature_minimum";

/// Those that the scheme with such segments may set, each with its meaning.
[[nodiscard]] std::vector<MarkSpec> of(SegmentKind kind);

}  // namespace kappabench::kappa::marks
