#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>

#include "experiments/program/draw_report.hpp"
#include "experiments/program/errors.hpp"
#include "experiments/program/run_with_bar.hpp"
#include "experiments/program/verbs.hpp"
#include "experiments/run/experiment.hpp"
#include "experiments/run/plan.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

Plan plan_of(const std::vector<std::string>& plans_or_experiments) {
  Plan plan;
  for (const std::string& name : plans_or_experiments) {
    if (!name.ends_with(".toml")) {
      plan.experiments.push_back({.id = name});
      continue;
    }
    Plan read = read_plan(name);
    plan.seed = read.seed;
    std::ranges::move(read.experiments, std::back_inserter(plan.experiments));
  }
  return plan;
}

struct Shard {
  int index = 1;
  int count = 1;
};

Shard parse_shard(std::string_view text) {
  if (text.empty()) return {};
  Shard shard{0, 0};
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ptr != end && *index.ptr == '/') {
    const auto count = std::from_chars(index.ptr + 1, end, shard.count);
    if (count.ptr == end && 1 <= shard.index && shard.index <= shard.count) return shard;
  }
  throw UsageError(fmt::format("--shard {}: must be I/N with 1 <= I <= N, such as 1/4", text));
}

/// Lost cells are rows of the results, but whoever started the run must learn of them.
int status_of(const RunSummary& summary, const fs::path& results) {
  if (summary.lost == 0) return success;
  fmt::print(stderr, "kappabench: {}: {} cells crashed, timed out or failed; the report lists them\n", results.string(),
             summary.lost);
  return ran_and_failed;
}

}  // namespace

int run_verb(const Registry& registry, const RunArguments& arguments) {
  const Shard shard = parse_shard(arguments.shard);
  const RunSummary summary = run_with_bar(registry, plan_of(arguments.plans_or_experiments),
                                          {.results = arguments.results,
                                           .processes = arguments.processes,
                                           .timeout = arguments.timeout,
                                           .resume = arguments.resume,
                                           .shard = shard.index,
                                           .shards = shard.count});
  fmt::print("{}\n", arguments.results.string());
  return status_of(summary, arguments.results);
}

int reproduce(const Registry& registry, const ReproduceArguments& arguments) {
  Plan plan;
  for (const Experiment& experiment : all_experiments())
    if (arguments.experiments.empty()) plan.experiments.push_back({.id = experiment.id});
  for (const std::string& id : arguments.experiments) plan.experiments.push_back({.id = id});
  std::error_code error;
  fs::create_directories(arguments.folder, error);
  if (error) throw UsageError(fmt::format("{}: cannot be made ({})", arguments.folder.string(), error.message()));

  const fs::path results = arguments.folder / "results.h5";
  const RunSummary summary = run_with_bar(registry, plan, {.results = results, .processes = arguments.processes});
  draw_report(summary.results, arguments.folder);
  fmt::print("{}\n", (arguments.folder / "index.html").string());
  return status_of(summary, results);
}

int merge_verb(const Registry& registry, const MergeArguments& arguments) {
  store::write_results(arguments.results, merge(registry, arguments.shards));
  fmt::print("{}\n", arguments.results.string());
  return success;
}

int report(const ReportArguments& arguments) {
  draw_report(store::read_results(arguments.results), arguments.folder);
  fmt::print("{}\n", (arguments.folder / "index.html").string());
  return success;
}

}  // namespace kappabench
