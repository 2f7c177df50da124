#include "reports/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "reports/atomic_file.hpp"
#include "reports/figures/figure.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/html.hpp"
#include "reports/tables.hpp"

namespace kappabench {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw FileError(fmt::format("{}: the folder cannot be made: {}", folder.string(),
                                error ? error.message() : "a file of that name is in the way"));
  }
}

/// A folder for gnuplot to work in, beside the figures so that results move by renaming.
class WorkFolder {
 public:
  explicit WorkFolder(fs::path path) : path_(std::move(path)) { make_folder(path_); }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A picture that is whole replaces the earlier one; an absent or empty one does not.
bool move_picture(const fs::path& from, const fs::path& to) {
  std::error_code error;
  if (fs::file_size(from, error) == 0 || error) return false;
  fs::rename(from, to, error);
  return !error;
}

struct FigureTask {
  const store::ExperimentRecord* experiment;
  const store::FigureRecord* figure;
  std::string stem;
};

/// Draws and renders one figure into `folder`; never throws for what is wrong with the figure itself.
FigureState make_figure(const FigureTask& task, const fs::path& folder, const ReportOptions& options) {
  FigureState state;
  FigureFiles files;
  try {
    files = draw_figure(*task.figure, *task.experiment, task.stem);
  } catch (const std::invalid_argument& error) {
    state.problem = error.what();
    return state;
  }
  const WorkFolder work(folder / fmt::format(".{}.work-{}", task.stem, ::getpid()));
  const std::string script = task.stem + ".gp";
  for (const fs::path& place : {work.path(), folder}) {
    replace_file(place / script, files.script);
    for (const auto& [name, text] : files.data) replace_file(place / name, text);
  }
  state.files.push_back(script);
  for (const auto& [name, text] : files.data) state.files.push_back(name);
  state.problem = run_gnuplot(work.path(), script, options.gnuplot).problem;
  if (!state.problem.empty()) return state;
  for (const char* kind : {".svg", ".png"}) {
    const std::string name = task.stem + kind;
    if (move_picture(work.path() / name, folder / name)) {
      state.files.push_back(name);
    } else {
      state.problem = fmt::format("{} was not made", name);
    }
  }
  return state;
}

/// Counts under a lock, so that calls of the callback never overlap.
class Counter {
 public:
  Counter(const Progress& progress, std::size_t total) : progress_(progress), total_(total) {}
  void done(std::string_view what) {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (progress_) progress_(done_, total_, what);
  }

 private:
  const Progress& progress_;
  std::size_t total_, done_ = 0;
  std::mutex mutex_;
};

std::vector<FigureState> make_figures(const std::vector<FigureTask>& tasks, const fs::path& folder,
                                      const ReportOptions& options, Counter& counter) {
  std::vector<FigureState> states(tasks.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr trouble;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      try {
        states[i] = make_figure(tasks[i], folder, options);
        counter.done(tasks[i].stem);
      } catch (...) {
        const std::lock_guard lock(mutex);
        trouble = std::current_exception();
        next = tasks.size();
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < std::max(1, options.jobs); ++i) workers.emplace_back(work);
  }
  if (trouble) std::rethrow_exception(trouble);
  return states;
}

void write_tables(const store::Results& results, const fs::path& folder, Counter& counter) {
  for (const auto& experiment : results.experiments) {
    for (const auto& table : experiment.tables) {
      const std::string stem = file_stem(experiment.id, table.id);
      replace_file(folder / (stem + ".md"), to_markdown(table));
      replace_file(folder / (stem + ".csv"), to_csv(table));
      replace_file(folder / (stem + ".tex"), to_latex(table));
      counter.done(stem);
    }
  }
}

/// Two tables or two figures that would share a file are refused.
void refuse_shared_names(const store::Results& results) {
  const auto check = [](std::set<std::string>& seen, const std::string& stem) {
    if (!seen.insert(stem).second) {
      throw std::invalid_argument(fmt::format("two tables or figures would be written to the files '{}'", stem));
    }
  };
  std::set<std::string> tables, figures;
  for (const auto& experiment : results.experiments) {
    for (const auto& table : experiment.tables) check(tables, file_stem(experiment.id, table.id));
    for (const auto& figure : experiment.figures) check(figures, file_stem(experiment.id, figure.id));
  }
}

std::vector<std::string> strange_claims(const store::Results& results, const std::vector<Paper>& papers) {
  std::vector<std::string> warnings;
  for (const auto& experiment : results.experiments) {
    for (const auto& record : experiment.claims) {
      const bool known = std::any_of(papers.begin(), papers.end(), [&](const Paper& paper) {
        return paper.id == record.paper && std::any_of(paper.claims.begin(), paper.claims.end(),
                                                       [&](const auto& claim) { return claim.id == record.claim; });
      });
      if (!known) {
        warnings.push_back(
            fmt::format("{}: the file of paper '{}' has no claim '{}'", experiment.id, record.paper, record.claim));
      }
      if (std::ranges::find(store::verdicts, record.verdict) == store::verdicts.end()) {
        warnings.push_back(
            fmt::format("{}: claim '{}' has the unknown verdict '{}'", experiment.id, record.claim, record.verdict));
      }
    }
  }
  return warnings;
}

}  // namespace

std::string file_stem(std::string_view experiment, std::string_view id) {
  const bool named = id == experiment || id.starts_with(fmt::format("{}-", experiment));
  std::string stem = named ? std::string(id) : fmt::format("{}-{}", experiment, id);
  for (char& c : stem) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '_') c = '_';
  }
  return stem.starts_with('.') ? "_" + stem : stem;
}

std::vector<std::string> write_report(const store::Results& results, const fs::path& folder, const Progress& progress,
                                      const ReportOptions& options) {
  refuse_shared_names(results);
  const std::vector<Paper>& papers = options.papers;
  std::vector<FigureTask> tasks;
  std::size_t total = 1;
  for (const auto& experiment : results.experiments) {
    total += experiment.tables.size() + experiment.figures.size();
    for (const auto& figure : experiment.figures)
      tasks.push_back({&experiment, &figure, file_stem(experiment.id, figure.id)});
  }
  make_folder(folder / "tables");
  make_folder(folder / "figures");
  Counter counter(progress, total);
  write_tables(results, folder / "tables", counter);
  const auto states = make_figures(tasks, folder / "figures", options, counter);

  std::vector<std::string> warnings = strange_claims(results, papers);
  std::map<std::string, FigureState> figures;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    figures[tasks[i].stem] = states[i];
    const std::string& problem = states[i].problem;
    const bool told =
        std::any_of(warnings.begin(), warnings.end(), [&](const auto& w) { return w.ends_with(problem); });
    if (!problem.empty() && !told) warnings.push_back(fmt::format("figure {}: {}", tasks[i].stem, problem));
  }
  const std::string gnuplot = tasks.empty() ? std::string() : gnuplot_version(folder, options.gnuplot);
  replace_file(folder / "index.html", to_html(results, papers, figures, gnuplot));
  counter.done("index.html");
  return warnings;
}

}  // namespace kappabench
