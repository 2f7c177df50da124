#include "experiments/run/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "experiments/run/experiment.hpp"
#include "experiments/run/house.hpp"
#include "experiments/run/provenance.hpp"
#include "experiments/run/workers.hpp"
#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

namespace fs = std::filesystem;

/// An experiment of a plan with its cells laid out.
struct Prepared {
  const Experiment* experiment;
  Context context;
  std::vector<CellJob> jobs;
};

std::vector<Prepared> prepare(const Registry& registry, const Plan& plan) {
  std::vector<Prepared> prepared;
  for (const PlannedExperiment& planned : plan.experiments) {
    Context context{registry, plan.seed, planned.schemes, planned.datasets, planned.metrics};
    const Experiment& experiment = find_experiment(planned.id);
    std::vector<CellJob> jobs = experiment.jobs(context);
    prepared.push_back({&experiment, std::move(context), std::move(jobs)});
  }
  return prepared;
}

/// Distinct jobs of this shard: experiments may share cells.
std::vector<CellJob> jobs_of_shard(const std::vector<Prepared>& prepared, const RunOptions& options) {
  std::map<std::string, bool> seen;
  std::vector<CellJob> mine;
  int index = 0;
  for (const Prepared& p : prepared)
    for (const CellJob& job : p.jobs)
      if (seen.emplace(job.key(), true).second && index++ % options.shards == options.shard - 1) mine.push_back(job);
  return mine;
}

using Cells = std::map<std::string, store::CellRecord>;
using Beside = decltype(RunOptions::beside);

void collect(Cells& cells, store::Results&& results) {
  for (store::ExperimentRecord& experiment : results.experiments)
    for (store::CellRecord& cell : experiment.cells) cells.emplace(cell.key, std::move(cell));
}

bool lost(const store::CellRecord& cell) {
  return cell.outcome == name(Outcome::crashed) || cell.outcome == name(Outcome::timed_out) ||
         cell.outcome == name(Outcome::failed);
}

/// Makes sure that results can be written before anything is computed, and clears or keeps earlier cells.
fs::path prepare_folder(const RunOptions& options) {
  const fs::path folder = options.results.string() + ".cells";
  std::error_code error;
  if (!options.resume) fs::remove_all(folder, error);
  fs::create_directories(folder, error);
  if (error)
    throw std::runtime_error(fmt::format("{}: cannot be written ({}); choose another place with -o",
                                         options.results.string(), error.message()));
  return folder;
}

/// Cells of an earlier, finished run that this plan still wants.
void reuse_cells(const RunOptions& options, const std::vector<CellJob>& jobs, const fs::path& folder) {
  if (!options.resume || !fs::exists(options.results)) return;
  Cells old;
  collect(old, store::read_results(options.results));
  for (const CellJob& job : jobs) {
    const auto found = old.find(job.key());
    if (found != old.end() && !lost(found->second) && !fs::exists(cell_file(folder, job)))
      store::write_cell(cell_file(folder, job), found->second);
  }
}

/// Experiments of the plan with the cells there are. With all of them there, tables, figures and verdicts follow.
store::Results assemble(const Registry& registry, const std::vector<Prepared>& prepared, const Plan& plan,
                        const Cells& cells, bool complete, const Beside& beside = {}) {
  store::Results results;
  results.provenance = provenance(registry);
  results.provenance["plan"] = to_toml(plan);
  results.provenance["seed"] = fmt::format("{}", plan.seed);
  for (const Prepared& p : prepared) {
    store::ExperimentRecord record;
    record.id = p.experiment->id;
    record.title = p.experiment->title;
    record.about = p.experiment->about;
    for (const CellJob& job : p.jobs) {
      const auto found = cells.find(job.key());
      if (found == cells.end()) continue;
      record.cells.push_back(found->second);
      // Equal points under another name are the same cell.
      record.cells.back().dataset = job.dataset;
      record.cells.back().label = job.label;
    }
    if (const auto others = beside.find(record.id); others != beside.end())
      std::ranges::copy(others->second, std::back_inserter(record.cells));
    if (complete) conclude(*p.experiment, p.context, record);
    results.experiments.push_back(std::move(record));
  }
  return results;
}

}  // namespace

RunSummary run(const Registry& registry, const Plan& plan, const RunOptions& options) {
  const std::vector<Prepared> prepared = prepare(registry, plan);
  const std::vector<CellJob> jobs = jobs_of_shard(prepared, options);
  const fs::path folder = prepare_folder(options);
  reuse_cells(options, jobs, folder);

  std::size_t done = 0;
  compute_cells(jobs, {.processes = options.processes, .timeout = options.timeout, .folder = folder},
                [&](const CellJob& job) {
                  ++done;
                  if (options.progress) options.progress(done, jobs.size(), job.dataset + " " + job.label);
                });

  Cells cells;
  RunSummary summary;
  for (const CellJob& job : jobs) {
    store::CellRecord cell = store::read_cell(cell_file(folder, job));
    if (lost(cell)) ++summary.lost;
    cells.emplace(job.key(), std::move(cell));
  }
  summary.results = assemble(registry, prepared, plan, cells, options.shards == 1, options.beside);
  store::write_results(options.results, summary.results);
  fs::remove_all(folder);
  return summary;
}

store::Results merge(const Registry& registry, const std::vector<fs::path>& shards) {
  Cells cells;
  std::string plan_text;
  for (const fs::path& file : shards) {
    store::Results part = store::read_results(file);
    const std::string& text = part.provenance["plan"];
    if (!plan_text.empty() && text != plan_text)
      throw std::invalid_argument(fmt::format("{}: was run with another plan than {}; merge shards of one plan",
                                              file.string(), shards.front().string()));
    plan_text = text;
    collect(cells, std::move(part));
  }
  const Plan plan = parse_plan(plan_text, shards.front().string() + " (plan)");
  const std::vector<Prepared> prepared = prepare(registry, plan);
  std::size_t missing = 0;
  for (const Prepared& p : prepared)
    for (const CellJob& job : p.jobs) missing += cells.contains(job.key()) ? 0 : 1;
  if (missing > 0)
    throw std::invalid_argument(
        fmt::format("{} cells of the plan are in none of the files; run the missing shards", missing));
  return assemble(registry, prepared, plan, cells, true);
}

}  // namespace kappabench
