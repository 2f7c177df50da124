#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// The fits of a drawing as text: "json" (an object, or an array if there are several curves), "csv" (samples with
/// curvature), "svg" (a picture), "xy" (sampled points, a blank line between curves).
/// Throws std::invalid_argument naming the formats.
[[nodiscard]] std::string format_fits(std::string_view format, const Scheme& scheme, const std::vector<Fit>& fits);

}  // namespace kappabench
