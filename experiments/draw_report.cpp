#include "experiments/draw_report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "experiments/progress_bar.hpp"
#include "reports/report.hpp"

namespace kappabench {

void draw_report(const store::Results& results, const std::filesystem::path& folder) {
  std::vector<std::string> problems;
  {
    const ProgressBar bar("drawing");
    problems = write_report(results, folder, [&bar](std::size_t done, std::size_t total, std::string_view what) {
      bar.show(done, total, what);
    });
  }
  for (const std::string& problem : problems) fmt::print(stderr, "kappabench: {}\n", problem);
}

}  // namespace kappabench
