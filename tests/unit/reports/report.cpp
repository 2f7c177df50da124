#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "reports/atomic_file.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/html.hpp"
#include "reports/report.hpp"
#include "tests/catch.hpp"
#include "tests/unit/reports/synthetic.hpp"

namespace fs = std::filesystem;
using namespace kappabench;
using synthetic::read_text;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Everything that the page refers to.
std::set<std::string> references(const std::string& html) {
  static const std::regex pattern("(?:href|src)=\"([^\"]*)\"");
  std::set<std::string> found;
  for (std::sregex_iterator match(html.begin(), html.end(), pattern), end; match != end; ++match) {
    found.insert((*match)[1].str());
  }
  return found;
}

std::set<std::string> files_under(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), folder).string());
  }
  return names;
}

void check_references(const fs::path& folder) {
  const std::string html = read_text(folder / "index.html");
  for (const auto& reference : references(html)) {
    INFO(reference);
    if (reference.starts_with("#")) {
      CHECK(has(html, "id=\"" + reference.substr(1) + "\""));
    } else {
      CHECK(fs::exists(folder / reference));
    }
  }
}

}  // namespace

TEST_CASE("A report holds every table, figure and claim, and no link is broken") {
  const ScratchFolder folder;
  const auto results = synthetic::results();
  std::size_t calls = 0, last = 0, total = 0;
  const auto warnings = write_report(results, folder.path(), [&](std::size_t done, std::size_t of, std::string_view) {
    ++calls;
    last = done;
    total = of;
  });
  CHECK(calls == 6);  // two tables, three figures, the page
  CHECK(last == 6);
  CHECK(total == 6);
  const std::string html = read_text(folder.path() / "index.html");
  const bool drawn = run_gnuplot(folder.path(), "/dev/null").installed;
  CHECK(warnings.empty() == drawn);
  CHECK(has(html, "gnuplot, of the figures") == drawn);
  for (const auto& experiment : results.experiments) {
    CHECK(has(html, html_escaped(experiment.title)));
    for (const auto& table : experiment.tables) {
      const auto stem = file_stem(experiment.id, table.id);
      CHECK(has(html, "id=\"table-" + stem + "\""));
      for (const char* kind : {".md", ".csv", ".tex"})
        CHECK(fs::file_size(folder.path() / "tables" / (stem + kind)) > 0);
    }
    for (const auto& figure : experiment.figures) {
      const auto stem = file_stem(experiment.id, figure.id);
      CHECK(has(html, "id=\"figure-" + stem + "\""));
      CHECK(fs::exists(folder.path() / "figures" / (stem + ".gp")));
      if (drawn) {
        CHECK(has(html, "<img src=\"figures/" + stem + ".svg\""));
        CHECK(has(html, "figures/" + stem + ".png"));
      }
    }
    for (const auto& claim : experiment.claims) {
      CHECK(has(html, html_escaped(claim.evidence)));
      CHECK(has(html, html_escaped(claim.ours)));
    }
  }
  CHECK(has(html, "5 cells: 3 converged, 1 not converged, 1 timed out"));
  CHECK(has(html, "stopped after 10 s"));
  CHECK(has(html, "Sect. 3, property 2"));
  CHECK(has(html, "not tested"));
  CHECK_FALSE(has(html, "http"));
  CHECK_FALSE(has(html, "<curves>"));
  check_references(folder.path());
}

TEST_CASE("Two reports of the same results are the same bytes") {
  const ScratchFolder one, two;
  write_report(synthetic::results(), one.path());
  write_report(synthetic::results(), two.path());
  write_report(synthetic::results(), two.path());  // over the earlier one
  const auto names = files_under(one.path());
  REQUIRE(names == files_under(two.path()));
  for (const auto& name : names) {
    INFO(name);
    CHECK(read_text(one.path() / name) == read_text(two.path() / name));
  }
}

TEST_CASE("Without gnuplot everything else is written, and one line says what is missing") {
  const ScratchFolder folder;
  ReportOptions options;
  options.gnuplot = "no-such-gnuplot";
  const auto warnings = write_report(synthetic::results(), folder.path(), {}, options);
  REQUIRE(warnings.size() == 1);
  CHECK(has(warnings[0], "package gnuplot"));
  CHECK(fs::exists(folder.path() / "figures" / "ekappa-synthetic-single.gp"));
  CHECK(fs::exists(folder.path() / "figures" / "ekappa-synthetic-single.dat"));
  CHECK(has(read_text(folder.path() / "index.html"), "No picture: &#39;no-such-gnuplot&#39; is not installed"));
  check_references(folder.path());
}

TEST_CASE("A figure that cannot be drawn does not stop the report and keeps the earlier picture") {
  const ScratchFolder folder;
  auto results = synthetic::results();
  write_report(results, folder.path());
  const auto before = files_under(folder.path());
  results.experiments[0].figures[2].panels[0].cells = {77};
  const auto warnings = write_report(results, folder.path());
  REQUIRE(warnings.size() == 1);
  CHECK(has(warnings[0], "no cell 77"));
  CHECK(has(read_text(folder.path() / "index.html"), "no cell 77"));
  CHECK(files_under(folder.path()) == before);
}

TEST_CASE("Claims without a paper and odd verdicts are told") {
  const ScratchFolder folder;
  store::Results results;
  auto& experiment = results.experiments.emplace_back();
  experiment.id = "e";
  experiment.claims = {{"ekappa-2022-miura", "no-such-claim", "reproduced", "", ""},
                       {"ekappa-2022-miura", "unique-parameter", "perhaps", "", ""}};
  const auto warnings = write_report(results, folder.path());
  REQUIRE(warnings.size() == 2);
  CHECK(has(warnings[0], "no-such-claim"));
  CHECK(has(warnings[1], "perhaps"));
}

TEST_CASE("Names of files are safe and not shared") {
  CHECK(file_stem("pkappa-toy", "pkappa-toy-curves") == "pkappa-toy-curves");
  CHECK(file_stem("pkappa-toy", "curves") == "pkappa-toy-curves");
  CHECK(file_stem("g", "gallery") == "g-gallery");
  CHECK(file_stem("a/../b", "x y") == "a_.._b-x_y");
  CHECK(file_stem("..", "x") == "_..-x");
  const ScratchFolder folder;
  auto results = synthetic::results();
  results.experiments[0].tables.push_back(results.experiments[0].tables[0]);
  CHECK_THROWS_AS(write_report(results, folder.path()), std::invalid_argument);
}

TEST_CASE("A report that cannot be written says where") {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  CHECK_THROWS_AS(write_report(synthetic::results(), folder.path() / "file"), FileError);
}
