#pragma once

#include <filesystem>

#include "reports/store/model.hpp"

namespace kappabench {

/// Writes tables, figures and index.html with a progress bar; what could not be drawn is a line on stderr each.
void draw_report(const store::Results& results, const std::filesystem::path& folder);

}  // namespace kappabench
