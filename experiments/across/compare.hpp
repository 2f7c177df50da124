#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "experiments/study/findings.hpp"

namespace kappabench {

/// The table with one row for every curve and scheme, which the verb `compare` prints.
inline constexpr std::string_view compare_table_id = "compare";

namespace comparison {

// What `compare` concludes, by idea.

/// Every curve and scheme in a row, and each scheme over all curves.
[[nodiscard]] study::Table curve_table(const study::Findings& found);
[[nodiscard]] study::Table scheme_table(const study::Findings& found);

/// How far curves that were made elsewhere pass from the points; nothing if there are no such curves.
[[nodiscard]] std::optional<study::Table> distance_table(const study::Findings& found);

/// Shares of curves by value and by time.
[[nodiscard]] std::vector<study::Table> distribution_tables(const study::Findings& found);
[[nodiscard]] study::Table profile_table(const study::Findings& found);
[[nodiscard]] store::FigureRecord distribution_figure();

/// For each drawing, a panel a scheme with combs.
[[nodiscard]] std::vector<store::FigureRecord> drawing_figures(const study::Findings& found);
/// Curvature against arc length, and residual against iteration: all schemes over one another, a panel a drawing.
[[nodiscard]] store::FigureRecord curvature_figure(const study::Findings& found);
[[nodiscard]] store::FigureRecord convergence_figure(const study::Findings& found);

}  // namespace comparison
}  // namespace kappabench
