#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "datasets/datasets.hpp"
#include "experiments/program/draw_report.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/format_comparison.hpp"
#include "experiments/program/open_curves.hpp"
#include "experiments/program/run_with_bar.hpp"
#include "experiments/program/scratch_folder.hpp"
#include "experiments/program/verbs.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

/// "--schemes kappa,ekappa:a=0.8,iteration=published,catmull-rom" split at its commas: an item "key=value" without a
/// colon goes on with the parameters of the scheme before it.
std::vector<std::string> join_parameters(const std::vector<std::string>& items) {
  std::vector<std::string> schemes;
  for (const std::string& item : items) {
    const bool continues = item.find('=') != std::string::npos && item.find(':') == std::string::npos;
    if (continues && !schemes.empty())
      schemes.back() += "," + item;
    else
      schemes.push_back(item);
  }
  return schemes;
}

/// Was the cell computed for the points of the drawing?
bool of_the_same_points(const store::CellRecord& cell, const Drawing& drawing) {
  const auto same = [](const store::CurveRecord& curve, const Input& input) {
    if (curve.closed != input.closed || curve.point_x.size() != input.points.size()) return false;
    for (std::size_t i = 0; i < input.points.size(); ++i)
      if (input.points[i] != Vec2(curve.point_x[i], curve.point_y[i])) return false;
    return true;
  };
  return std::ranges::equal(cell.curves, drawing.curves, same);
}

/// The experiment `compare` of a results file.
store::ExperimentRecord comparison_in(const fs::path& file) {
  store::Results results = store::read_results(file);
  const auto found = std::ranges::find(results.experiments, "compare", &store::ExperimentRecord::id);
  if (found == results.experiments.end())
    throw UsageError(
        fmt::format("{}: has no experiment 'compare'; make one with 'kappabench reproduce compare'", file.string()));
  return std::move(*found);
}

/// The cells of a results file whose points are those of the drawings, under the drawings' names, labelled with the
/// file's name: what stands beside the schemes that are computed here.
std::vector<store::CellRecord> published_cells(const fs::path& file, const std::vector<std::string>& points) {
  const store::ExperimentRecord published = comparison_in(file);
  std::vector<store::CellRecord> cells;
  const auto add_those_of = [&](const Drawing& drawing) {
    for (const store::CellRecord& cell : published.cells) {
      if (!of_the_same_points(cell, drawing)) continue;
      cells.push_back(cell);
      cells.back().dataset = drawing.id;
      cells.back().label += fmt::format(" [{}]", file.filename().string());
    }
  };
  for (const std::string& named : points)
    for (const Drawing& drawing : open_drawings(named)) add_those_of(drawing);
  if (cells.empty())
    throw UsageError(
        fmt::format("{}: nothing in it was computed for the points of {}; 'kappabench report' shows what was",
                    file.string(), fmt::join(points, ", ")));
  return cells;
}

/// The schemes asked for, all of them if none, and curves that were made elsewhere, which the registry then knows.
std::vector<std::string> with_curves(std::vector<std::string> schemes, const std::vector<std::string>& files,
                                     Registry& registry) {
  if (files.empty()) return schemes;
  if (schemes.empty())
    for (const SchemeInfo& info : registry.list()) schemes.push_back(info.id);
  for (const auto& curves : open_curves(files, registry)) {
    registry.add(curves->info(), [curves](const Parameters&) { return curves; });
    schemes.push_back(curves->info().id);
  }
  return schemes;
}

}  // namespace

int compare(const Registry& known, const CompareArguments& arguments) {
  if (!arguments.against.empty() && arguments.schemes.empty())
    throw UsageError("--against holds some schemes against those of a results file; name them with --schemes");
  Registry registry = known;
  Plan plan;
  plan.experiments.push_back({.id = "compare",
                              .schemes = with_curves(join_parameters(arguments.schemes), arguments.curves, registry),
                              .datasets = arguments.points,
                              .metrics = arguments.metrics});
  const bool keep = !arguments.output.empty();
  const ScratchFolder scratch;
  if (keep) fs::create_directories(arguments.output);
  const fs::path results = (keep ? arguments.output : scratch.path()) / "results.h5";
  RunOptions options{.results = results, .processes = arguments.processes};
  if (!arguments.against.empty()) options.beside["compare"] = published_cells(arguments.against, arguments.points);
  const RunSummary summary = run_with_bar(registry, plan, options);

  const store::ExperimentRecord& experiment = summary.results.experiments.front();
  fmt::print("{}", formatted_comparison(experiment, arguments.format, !arguments.metrics.empty()));
  if (keep) {
    draw_report(summary.results, arguments.output);
    fmt::print(stderr, "kappabench: the page is {}\n", (arguments.output / "index.html").string());
  }
  return summary.lost == 0 ? success : ran_and_failed;
}

}  // namespace kappabench
