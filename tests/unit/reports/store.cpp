#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

#include "reports/paper.hpp"
#include "reports/store/hdf5_store.hpp"
#include "tests/catch.hpp"
#include "tests/unit/reports/synthetic.hpp"

namespace fs = std::filesystem;
using namespace kappabench;

namespace {

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const store::StoreError& error) {
    return error.what();
  }
  return "";
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// NaN differs from itself: compare without it, and look for it apart.
store::Results without_nan() {
  auto results = synthetic::results();
  for (auto& table : results.experiments[0].tables) {
    for (auto& column : table.columns) {
      if (auto* cells = std::get_if<std::vector<double>>(&column.cells)) {
        for (double& cell : *cells) cell = cell == cell ? cell : -1.0;
      }
    }
  }
  return results;
}

std::string python_with_h5py() {
  for (const std::string name : {"python3", "/usr/bin/python3"}) {
    if (std::system((name + " -c 'import h5py' >/dev/null 2>&1").c_str()) == 0) return name;
  }
  return "";
}

/// Writing beyond `limit` bytes fails, as on a full disk, while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t limit) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit now{limit, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

}  // namespace

TEST_CASE("The store gives back what was written") {
  const ScratchFolder folder;
  const auto file = folder.path() / "results.h5";
  const auto results = without_nan();
  store::write_results(file, results);
  const auto again = store::read_results(file);
  REQUIRE(again.experiments.size() == results.experiments.size());
  for (std::size_t i = 0; i < results.experiments.size(); ++i) {
    CHECK(again.experiments[i].id == results.experiments[i].id);
    CHECK(again.experiments[i].cells == results.experiments[i].cells);
    CHECK(again.experiments[i].tables == results.experiments[i].tables);
    CHECK(again.experiments[i].figures == results.experiments[i].figures);
    CHECK(again.experiments[i].claims == results.experiments[i].claims);
  }
  CHECK(again.provenance == results.provenance);
  CHECK(again == results);
}

TEST_CASE("The store gives back the warnings of a curve") {
  const ScratchFolder folder;
  auto results = synthetic::results();
  results.experiments[0].cells[0].curves[0].warnings = {{"long_span", 2}, {"winding_span", 1}};
  store::write_results(folder.path() / "r.h5", results);
  const auto read = store::read_results(folder.path() / "r.h5");
  CHECK(store::warning_words(read.experiments[0].cells[0].curves[0]) == "long_span winding_span");
  CHECK(read.experiments[0].cells[0].curves[0].warnings == results.experiments[0].cells[0].curves[0].warnings);
}

TEST_CASE("The store keeps NaN, infinity, odd names and long words") {
  const ScratchFolder folder;
  const auto file = folder.path() / "results.h5";
  store::Results results;
  auto& experiment = results.experiments.emplace_back();
  experiment.id = "odd/id";
  experiment.tables.push_back({"t/1",
                               "κ–curves",
                               "",
                               {{"ratio a/b", "", "",
                                 std::vector<double>{std::numeric_limits<double>::quiet_NaN(),
                                                     -std::numeric_limits<double>::infinity(), 5e-324},
                                 false},
                                {"wörter", "", "", std::vector<std::string>{"", "é", std::string(70000, 'w')}, true}}});
  store::write_results(file, results);
  const auto again = store::read_results(file);
  const auto& columns = again.experiments.at(0).tables.at(0).columns;
  CHECK(again.experiments[0].id == "odd/id");
  CHECK(columns.at(0).name == "ratio a/b");
  const auto& numbers = std::get<std::vector<double>>(columns[0].cells);
  CHECK(std::isnan(numbers.at(0)));
  CHECK(numbers.at(1) == -std::numeric_limits<double>::infinity());
  CHECK(numbers.at(2) == 5e-324);
  CHECK(columns.at(1) == results.experiments[0].tables[0].columns[1]);
}

TEST_CASE("Equal results are equal bytes, and a write replaces the file") {
  const ScratchFolder folder;
  const auto results = synthetic::results();
  store::write_results(folder.path() / "a.h5", results);
  store::write_results(folder.path() / "b.h5", store::Results{});
  store::write_results(folder.path() / "b.h5", results);
  CHECK(synthetic::read_text(folder.path() / "a.h5") == synthetic::read_text(folder.path() / "b.h5"));
  CHECK(files_in(folder.path()) == 2);
}

TEST_CASE("A cell travels alone") {
  const ScratchFolder folder;
  for (const auto& cell : {synthetic::wave_cell("fpc", 0.5), synthetic::failed_cell(), store::CellRecord{}}) {
    store::write_cell(folder.path() / "cell.h5", cell);
    CHECK(store::read_cell(folder.path() / "cell.h5") == cell);
  }
  const auto error = error_of([&] { (void)store::read_results(folder.path() / "cell.h5"); });
  CHECK(error.find("kappabench-cell") != std::string::npos);
}

TEST_CASE("A tree that contradicts itself is refused") {
  const ScratchFolder folder;
  const auto file = folder.path() / "results.h5";
  auto results = synthetic::results();
  results.experiments[0].cells[0].curves[0].sample_kappa.pop_back();
  CHECK_THROWS_AS(store::write_results(file, results), std::invalid_argument);
  auto twice = synthetic::results();
  twice.experiments.push_back(twice.experiments[0]);
  CHECK_THROWS_AS(store::write_results(file, twice), std::invalid_argument);
  CHECK(files_in(folder.path()) == 0);
}

TEST_CASE("Files that are not results get one clear line") {
  const ScratchFolder folder;
  const auto good = folder.path() / "good.h5", bad = folder.path() / "bad.h5";
  store::write_results(good, synthetic::results());
  const auto bytes = synthetic::read_text(good);
  const auto message = [&] { return error_of([&] { (void)store::read_results(bad); }); };

  CHECK(message().find("no such file") != std::string::npos);
  write_bytes(bad, "x y\n0 0\n");
  CHECK(message().find("not an HDF5 file") != std::string::npos);
  write_bytes(bad, "");
  CHECK(message().find("not an HDF5 file") != std::string::npos);
  for (const std::size_t part : {std::size_t{100}, bytes.size() / 3, bytes.size() - 1}) {
    write_bytes(bad, bytes.substr(0, part));
    CHECK(message().find("truncated") != std::string::npos);
    CHECK(message().find(bad.string()) == 0);
    CHECK(message().find('\n') == std::string::npos);
  }
  for (std::size_t place = 16; place < bytes.size() - 30; place += bytes.size() / 50) {
    auto flipped = bytes;
    flipped[place] = static_cast<char>(flipped[place] ^ 0x10);
    write_bytes(bad, flipped);
    CHECK(message().find("checksum") != std::string::npos);
  }
}

TEST_CASE("Another schema version is refused with both numbers") {
  const ScratchFolder folder;
  const auto file = folder.path() / "results.h5";
  store::write_results(file, store::Results{});
  {
    // The attribute's data follows its name in the file; find the number there and raise it.
    auto bytes = synthetic::read_text(file);
    const auto name = bytes.find("schema_version");
    REQUIRE(name != std::string::npos);
    const std::string written{static_cast<char>(store::schema_version), '\0', '\0', '\0'};
    // 16 bytes of padded name, 16 of the type, 8 of the scalar space
    REQUIRE(bytes.substr(name + 16 + 16 + 8, 4) == written);
    bytes[name + 16 + 16 + 8] = 9;
    bytes.resize(bytes.rfind("\nkappabench crc32"));
    boost::crc_32_type sum;
    sum.process_bytes(bytes.data(), bytes.size());
    write_bytes(file, bytes + fmt::format("\nkappabench crc32 {:08x}\n", sum.checksum()));
  }
  const auto error = error_of([&] { (void)store::read_results(file); });
  CHECK(error.find("schema version 9") != std::string::npos);
  CHECK(error.find(fmt::format("reads version {}", store::schema_version)) != std::string::npos);
}

TEST_CASE("A full disk leaves the earlier file untouched") {
  const ScratchFolder folder;
  const auto file = folder.path() / "results.h5";
  store::write_results(file, store::Results{});
  const auto before = synthetic::read_text(file);
  std::string error;
  {
    const FileSizeLimit limit(50000);
    error = error_of([&] { store::write_results(file, synthetic::results()); });
  }
  CHECK(error.find("cannot be written") != std::string::npos);
  CHECK(error.find(file.string()) == 0);
  CHECK(synthetic::read_text(file) == before);
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("A folder that is not there or is a file is named") {
  const ScratchFolder folder;
  const auto missing = folder.path() / "none" / "results.h5";
  CHECK(error_of([&] { store::write_results(missing, {}); }).find("No such file") != std::string::npos);
  write_bytes(folder.path() / "file", "x");
  const auto inside = folder.path() / "file" / "results.h5";
  CHECK(error_of([&] { store::write_results(inside, {}); }).find("Not a directory") != std::string::npos);
}

TEST_CASE("h5py reads the file without our code") {
  const ScratchFolder folder;
  const auto file = folder.path() / "results.h5", output = folder.path() / "output.txt";
  store::write_results(file, synthetic::results());
  const std::string python = python_with_h5py();
  if (python.empty()) {
    WARN("python3 has no h5py: reading from Python is not tested");
    return;
  }
  const auto script = std::filesystem::path(KAPPABENCH_SOURCE) / "reports/examples/read_results.py";
  const auto command = fmt::format("{} '{}' '{}' >'{}' 2>&1", python, script.string(), file.string(), output.string());
  const int status = std::system(command.c_str());
  const std::string said = synthetic::read_text(output);
  INFO(said);
  CHECK(status == 0);
  CHECK(said.find(fmt::format("schema_version: {}\n", store::schema_version)) != std::string::npos);
  CHECK(said.find("broken, kappa: timed_out stopped after 10 s") != std::string::npos);
  CHECK(said.find("24 iterations") != std::string::npos);
  CHECK(said.find("table energies: drawing, scheme, energy, extrema") != std::string::npos);
  CHECK(said.find("bending_energy = 12.5 (sampled)") != std::string::npos);
}
