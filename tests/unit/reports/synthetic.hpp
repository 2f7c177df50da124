#pragma once

#include <filesystem>
#include <string>

#include "experiments/program/scratch_folder.hpp"
#include "reports/store/model.hpp"

/// Results made of formulas, so that everything written can be tested without any scheme: a rounded polygon
/// r = 1 + b cos 3u in two versions, one of them not converged, an open wave with inflections, a curve with a huge
/// peak of curvature, and a failure.
namespace kappabench::synthetic {

[[nodiscard]] store::CellRecord polygon_cell(const std::string& label, double bump, bool converged);
[[nodiscard]] store::CellRecord wave_cell(const std::string& label, double height);
[[nodiscard]] store::CellRecord peak_cell();
[[nodiscard]] store::CellRecord failed_cell();

/// One experiment with every kind of panel, table and claim, and a second, nearly empty one.
[[nodiscard]] store::Results results();

[[nodiscard]] std::string read_text(const std::filesystem::path& file);

}  // namespace kappabench::synthetic
