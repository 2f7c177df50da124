#pragma once

#include <string>
#include <vector>

#include "experiments/study/findings.hpp"

namespace kappabench::wang {

/// Curvature against the parabola that it approximates, as in the lower halves of Figs. 5 and 9.

/// Fits, measures and keeps the parabola of every segment, for `parabola_table`.
[[nodiscard]] CellJob profiled_job(const Drawing& drawing, const SchemePtr& scheme, std::string label,
                                   std::vector<const Metric*> metrics);

/// Curvature and parabola against t + the segment's number from 0, for the cells that profiled_job made, `steps`
/// intervals a segment (a divisor of 64). Columns "curve" (label), "segment + t", "curvature", "parabola",
/// "difference".
[[nodiscard]] study::Table parabola_table(const study::Findings& found, std::string id, const std::vector<int>& cells,
                                          int steps);

/// A graph of parabola_table for a single cell.
[[nodiscard]] study::Panel parabola_panel(std::string title, std::string table, std::string x_label);

/// The same for curvature minus parabola.
[[nodiscard]] study::Panel difference_panel(std::string title, std::string table);

}  // namespace kappabench::wang
