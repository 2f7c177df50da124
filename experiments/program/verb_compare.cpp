#include <fmt/format.h>

#include <filesystem>

#include "experiments/program/draw_report.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/format_comparison.hpp"
#include "experiments/program/open_curves.hpp"
#include "experiments/program/run_with_bar.hpp"
#include "experiments/program/scratch_folder.hpp"
#include "experiments/program/verbs.hpp"

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
  const RunSummary summary = run_with_bar(registry, plan, {.results = results, .processes = arguments.processes});

  const store::ExperimentRecord& experiment = summary.results.experiments.front();
  fmt::print("{}", formatted_comparison(experiment, arguments.format, !arguments.metrics.empty()));
  if (keep) draw_report(summary.results, arguments.output);
  return summary.lost == 0 ? success : ran_and_failed;
}

}  // namespace kappabench
