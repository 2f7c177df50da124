#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/paper.hpp"
#include "reports/store/model.hpp"

namespace kappabench {

/// What became of a figure's files.
struct FigureState {
  std::vector<std::string> files;  ///< names in figures/, those that exist: .gp, .dat, .svg, .png
  std::string problem;             ///< why there is no picture; empty when there is one
};

/// The page of a whole report: one file with its style inside, links only to the files beside it. `figures` is by
/// file stem; `gnuplot` is the version of the program that drew them, if known.
[[nodiscard]] std::string to_html(const store::Results& results, const std::vector<Paper>& papers,
                                  const std::map<std::string, FigureState>& figures, std::string_view gnuplot = {});

/// `text` with &, <, > and quotes as entities.
[[nodiscard]] std::string html_escaped(std::string_view text);

}  // namespace kappabench
