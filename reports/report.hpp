#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/paper.hpp"
#include "reports/store/model.hpp"

namespace kappabench {

/// Told after every file or figure: how many are done, of how many, and which. Calls never overlap.
using Progress = std::function<void(std::size_t done, std::size_t total, std::string_view what)>;

struct ReportOptions {
  std::string gnuplot = "gnuplot";               ///< program that draws
  int jobs = 2;                                  ///< figures drawn at a time
  std::vector<Paper> papers = printed_papers();  ///< claims and printed numbers
};

/// Writes everything that can be read: `tables/*.md, *.csv, *.tex`, `figures/*.gp, *.dat, *.svg, *.png`, `index.html`.
/// Every file is written under a temporary name and renamed; files of an earlier report that are not made again stay.
///
/// Returns what could not be done, one line each: a figure that cannot be drawn, a claim that no paper has, gnuplot
/// missing (scripts and data are written all the same). Throws FileError when the folder cannot be written,
/// PaperError for an unusable file of claims, std::invalid_argument for a table that contradicts itself.
std::vector<std::string> write_report(const store::Results& results, const std::filesystem::path& folder,
                                      const Progress& progress = {}, const ReportOptions& options = {});

/// Name of the files of a table or figure: "<experiment>-<id>", or "<id>" when that starts with "<experiment>-";
/// letters, digits, '.', '-' and '_' only.
[[nodiscard]] std::string file_stem(std::string_view experiment, std::string_view id);

}  // namespace kappabench
