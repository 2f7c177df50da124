#include "experiments/program/draw_report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "experiments/program/progress_bar.hpp"
#include "reports/report.hpp"

namespace kappabench {

void draw_report(const store::Results& results, const std::filesystem::path& folder) {
  std::vector<std::string> problems;
  {
    ProgressBar bar("drawing");
    problems = write_report(results, folder, bar.callback());
  }
  for (const std::string& problem : problems) fmt::print(stderr, "kappabench: {}\n", problem);
}

}  // namespace kappabench
