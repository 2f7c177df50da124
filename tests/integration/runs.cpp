// Runs of plans: plans that are wrong, shards that join to the whole, and cells that crash or hang.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>
#include <thread>

#include "experiments/program/scratch_folder.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/run/runner.hpp"
#include "experiments/run/workers.hpp"
#include "reports/store/hdf5_store.hpp"
#include "tests/catch.hpp"
#include "tests/schemes.hpp"

using namespace kappabench;
using namespace kappabench::test;

namespace {

const Plan small_plan{.seed = 1,
                      .experiments = {{.id = "compare",
                                       .schemes = {"kappa", "ekappa:a=0.8", "cubic-spline"},
                                       .datasets = {"bird", "star"},
                                       .metrics = {"monotone_intervals"}}}};

CellJob job(std::string work, void (*compute)(const Uses&, store::CellRecord&)) {
  return {.dataset = "d", .label = "s", .uses = {.work = std::move(work)}, .compute = compute};
}

/// When and how long are what differs from run to run, and by which command.
store::Results without_timings(store::Results results) {
  for (const char* key : {"date", "command"}) results.provenance.erase(key);
  for (auto& experiment : results.experiments) {
    std::erase_if(experiment.tables, [](const auto& table) { return table.id == "profile-seconds"; });
    for (auto& cell : experiment.cells) {
      cell.timings.clear();
      for (auto& curve : cell.curves) curve.seconds = 0.0;
      for (auto& curve : cell.curves) {
        // "seconds" stands in the exact form too.
        const auto from = curve.exact_json.find("\"seconds\":"), to = curve.exact_json.find(",\"segments\"");
        if (from != std::string::npos) curve.exact_json.erase(from, to - from);
      }
    }
  }
  return results;
}

std::string bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("plans read back as they are written, and complain with file and line") {
  const Plan plan = parse_plan(to_toml(small_plan), "plan.toml");
  CHECK(to_toml(plan) == to_toml(small_plan));
  CHECK_THROWS_WITH(parse_plan("seed = 1\n[[experiment]]\nname = \"compare\"\n", "p.toml"),
                    ContainsSubstring("p.toml:3: unknown key 'name'; known are id, schemes, datasets, metrics"));
  CHECK_THROWS_WITH(parse_plan("seed = \n", "p.toml"), ContainsSubstring("p.toml:1"));
  CHECK_THROWS_WITH(parse_plan("", "p.toml"), ContainsSubstring("[[experiment]]"));
}

TEST_CASE("a results file says when, where, by which command and with which libraries it was made") {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "r.h5";
  (void)run(all_schemes(), small_plan, {.results = file, .processes = 2});
  const auto provenance = store::read_results(file).provenance;
  for (const char* key : {"date",  "command", "commit",        "dirty",        "compiler",         "flags", "os",
                          "cpu",   "threads", "seed",          "plan",         "c_library",        "eigen", "boost",
                          "fmt",   "cli11",   "nlohmann_json", "tomlplusplus", "google_benchmark", "hdf5",  "freetype",
                          "ceres", "nlopt",   "xsimd"}) {
    INFO(key);
    REQUIRE(provenance.contains(key));
    CHECK_FALSE(provenance.at(key).empty());
  }
  for (const auto& [key, text] : provenance) {
    INFO(key);
    CHECK_FALSE(text.empty());
  }
  for (const SchemeInfo& scheme : all_schemes().list())
    for (const auto& [library, version] : scheme.libraries) CHECK(provenance.at(library) == version);
  CHECK(std::regex_match(provenance.at("date"), std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
  CHECK_THAT(provenance.at("command"), ContainsSubstring("tests_integration"));
}

TEST_CASE("shards join to the same data as one run, and so does a run on one process") {
  const ScratchFolder folder;
  const auto file = [&](const std::string& name) { return folder.path() / name; };
  const auto whole = run(all_schemes(), small_plan, {.results = file("whole.h5"), .processes = 2});
  const auto alone = run(all_schemes(), small_plan, {.results = file("alone.h5"), .processes = 1});
  (void)run(all_schemes(), small_plan, {.results = file("1.h5"), .processes = 2, .shard = 1, .shards = 2});
  (void)run(all_schemes(), small_plan, {.results = file("2.h5"), .processes = 2, .shard = 2, .shards = 2});
  CHECK_THROWS_WITH(merge(all_schemes(), {file("1.h5")}), ContainsSubstring("in none of the files"));
  const auto merged = merge(all_schemes(), {file("2.h5"), file("1.h5")});

  store::write_results(file("a.h5"), without_timings(whole.results));
  store::write_results(file("b.h5"), without_timings(alone.results));
  store::write_results(file("c.h5"), without_timings(merged));
  CHECK(bytes(file("a.h5")) == bytes(file("b.h5")));
  CHECK(bytes(file("a.h5")) == bytes(file("c.h5")));
  CHECK_FALSE(std::filesystem::exists(file("whole.h5.cells")));
}

TEST_CASE("a resumed run computes only what is not there") {
  const ScratchFolder folder;
  const auto compute_count = [&folder] { return std::filesystem::file_size(folder.path() / "count"); };
  const auto count_one = [](const Uses& uses, store::CellRecord&) {
    std::ofstream(uses.words.at("file"), std::ios::app) << '.';
  };
  std::vector<CellJob> jobs{job("a", count_one), job("b", count_one)};
  for (CellJob& each : jobs) each.uses.words["file"] = (folder.path() / "count").string();
  const WorkerOptions options{.processes = 1, .folder = folder.path()};
  compute_cells(std::span(jobs).first(1), options, [](const CellJob&) {});
  CHECK(compute_count() == 1);
  compute_cells(jobs, options, [](const CellJob&) {});
  CHECK(compute_count() == 2);
}

TEST_CASE("a cell that crashes, throws or hangs is a row, and takes no other with it") {
  const ScratchFolder folder;
  const std::vector<CellJob> jobs{
      job("crash", [](const Uses&, store::CellRecord&) { std::raise(SIGKILL); }),
      job("throw", [](const Uses&, store::CellRecord&) { throw std::runtime_error("no such luck"); }),
      job("hang", [](const Uses&, store::CellRecord&) { std::this_thread::sleep_for(std::chrono::hours(1)); }),
      job("fine", [](const Uses&, store::CellRecord&) {})};
  compute_cells(jobs, {.processes = 4, .timeout = 1.0, .folder = folder.path()}, [](const CellJob&) {});
  const auto cell = [&](std::size_t i) { return store::read_cell(cell_file(folder.path(), jobs[i])); };
  CHECK(cell(0).outcome == "crashed");
  CHECK(cell(1).outcome == "failed");
  CHECK(cell(1).message == "no such luck");
  CHECK(cell(2).outcome == "timed_out");
  CHECK(cell(3).outcome == "converged");
  CHECK(cell(3).label == "s");
}
