#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// Which format a file is written in: `asked` if it is not empty, else what the file's ending says, else "json" (of
/// standard output, an empty name, and of devices without an ending). Throws std::invalid_argument for an ending that
/// is no format.
[[nodiscard]] std::string format_for(const std::filesystem::path& file, std::string_view asked);

/// The fits of a drawing as text: "json" (schemes/api/CURVE_JSON.md), "csv" (samples with curvature), "svg" (a
/// picture), "xy" (sampled points, a blank line between curves). Throws std::invalid_argument naming the formats.
[[nodiscard]] std::string format_fits(std::string_view format, const Scheme& scheme, const std::vector<Fit>& fits);

}  // namespace kappabench
