#include "experiments/run/workers.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <stdexcept>
#include <thread>

#include "reports/store/hdf5_store.hpp"

namespace kappabench {

namespace {

using Clock = std::chrono::steady_clock;

struct Running {
  const CellJob* job;
  Clock::time_point start;
  bool killed = false;
};

/// What a child tells its parent besides the cell file.
constexpr int cannot_write = 5;

/// The child: computes and writes, and never returns. An exception out of a scheme or a metric is a failed cell.
[[noreturn]] void compute_and_exit(const CellJob& job, const std::filesystem::path& file) {
  store::CellRecord cell;
  try {
    cell = compute(job);
  } catch (const std::exception& error) {
    cell.outcome = name(Outcome::failed);
    cell.message = error.what();
  }
  name_cell(cell, job);
  try {
    store::write_cell(file, cell);
  } catch (const std::exception& error) {
    fmt::print(stderr, "kappabench: {}\n", error.what());
    _exit(cannot_write);
  }
  _exit(0);
}

pid_t start(const CellJob& job, const std::filesystem::path& file) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (child == 0) compute_and_exit(job, file);
  return child;
}

void write_lost_cell(const CellJob& job, const std::filesystem::path& file, Outcome outcome, std::string message) {
  store::CellRecord cell;
  name_cell(cell, job);
  cell.outcome = name(outcome);
  cell.message = std::move(message);
  store::write_cell(file, cell);
}

/// Turns the way a child ended into a cell, if it left none itself.
void settle(const Running& running, int status, const std::filesystem::path& file, double timeout) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == cannot_write)
    throw std::runtime_error(fmt::format("cannot write results to {}; is the disk full?", file.parent_path().string()));
  if (running.killed)
    write_lost_cell(*running.job, file, Outcome::timed_out, fmt::format("took longer than {} s", timeout));
  else if (WIFSIGNALED(status))
    write_lost_cell(*running.job, file, Outcome::crashed,
                    fmt::format("ended by signal {}", strsignal(WTERMSIG(status))));
  else
    write_lost_cell(*running.job, file, Outcome::crashed, fmt::format("exited with status {}", WEXITSTATUS(status)));
}

void kill_overdue(std::map<pid_t, Running>& children, double timeout) {
  if (timeout <= 0.0) return;
  for (auto& [child, running] : children) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - running.start).count();
    if (elapsed <= timeout || running.killed) continue;
    running.killed = true;
    kill(child, SIGKILL);
  }
}

/// Ends the children when this process gives up, so that none is left behind.
struct Children {
  std::map<pid_t, Running> running;

  Children() = default;
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  ~Children() {
    for (const auto& [child, job] : running) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }
};

}  // namespace

std::filesystem::path cell_file(const std::filesystem::path& folder, const CellJob& job) {
  return folder / (job.key() + ".h5");
}

void compute_cells(std::span<const CellJob> jobs, const WorkerOptions& options,
                   const std::function<void(const CellJob&)>& finished) {
  Children children;
  auto next = jobs.begin();
  while (next != jobs.end() || !children.running.empty()) {
    while (next != jobs.end() && static_cast<int>(children.running.size()) < options.processes) {
      const CellJob& job = *next++;
      const auto file = cell_file(options.folder, job);
      if (std::filesystem::exists(file))
        finished(job);
      else
        children.running.emplace(start(job, file), Running{.job = &job, .start = Clock::now()});
    }
    int status = 0;
    const pid_t ended = waitpid(-1, &status, WNOHANG);
    const auto child = children.running.find(ended);
    if (child == children.running.end()) {
      kill_overdue(children.running, options.timeout);
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      continue;
    }
    const Running running = child->second;
    children.running.erase(child);
    settle(running, status, cell_file(options.folder, *running.job), options.timeout);
    finished(*running.job);
  }
}

}  // namespace kappabench
