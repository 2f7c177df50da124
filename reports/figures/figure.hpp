#pragma once

#include <map>
#include <string>

#include "reports/store/model.hpp"

namespace kappabench {

/// What redraws a figure: `<stem>.gp`, and one data file a panel (`<stem>.dat`, or `<stem>-1.dat`, ... when there are
/// several). `gnuplot <stem>.gp` in their folder makes `<stem>.svg` and `<stem>.png`.
struct FigureFiles {
  std::string script;
  std::map<std::string, std::string> data;  ///< file name to text
};

/// Draws one figure of an experiment. Rules that hold for every panel:
/// - one colour for one label in the whole figure, from a palette that colour-blind readers tell apart;
/// - a curve that did not converge is dashed and marked "(not converged)"; a cell without a curve is named as such;
/// - where a peak of curvature is cut off, the panel says so, and how large it is.
/// Throws std::invalid_argument when the figure refers to what is not there (a cell, a table, a column, a kind).
[[nodiscard]] FigureFiles draw_figure(const store::FigureRecord& figure, const store::ExperimentRecord& experiment,
                                      const std::string& stem);

}  // namespace kappabench
