#pragma once

#include <string_view>

/// What fpc says of a node; the counter of this name counts it.
namespace kappabench::fpc::marks {

/// The point's own segment has shrunk to nothing at an inflection; the node is the joint of its neighbours.
inline constexpr std::string_view at_inflection = "at_inflection";

}  // namespace kappabench::fpc::marks
