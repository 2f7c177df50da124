#include "reports/figures/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <system_error>
#include <thread>

extern char** environ;

namespace kappabench {
namespace {

constexpr auto time_limit = std::chrono::seconds(60);
constexpr const char* log_name = "gnuplot.log";

/// The wait status, or nothing after the time limit (the child is then killed).
bool wait_for(pid_t child, int& status) {
  const auto end = std::chrono::steady_clock::now() + time_limit;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return true;
    if (ended < 0 && errno != EINTR) return false;
    if (std::chrono::steady_clock::now() > end) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
  return false;
}

std::string first_line_said(const std::filesystem::path& log) {
  std::ifstream stream(log);
  std::string line;
  while (std::getline(stream, line)) {
    if (line.find_first_not_of(" \t^") != std::string::npos) return line;
  }
  return "";
}

}  // namespace

Rendering run_gnuplot(const std::filesystem::path& folder, const std::string& script, const std::string& program) {
  const auto log = folder / log_name;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log_name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  std::string name = program, argument = script;
  char* arguments[] = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int refused = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  std::error_code ignored;
  if (refused != 0) std::filesystem::remove(log, ignored);
  if (refused == ENOENT) {
    return {false, fmt::format("'{}' is not installed: install the package gnuplot", program)};
  }
  if (refused != 0) return {true, fmt::format("{}: {}", program, std::generic_category().message(refused))};
  int status = 0;
  const bool ended = wait_for(child, status);
  const std::string said = first_line_said(log);
  std::filesystem::remove(log, ignored);
  if (!ended) return {true, fmt::format("{}: {} stopped after {} s", script, program, time_limit.count())};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127 && said.empty())
    return {false, fmt::format("'{}' cannot be started", program)};
  if (!said.empty()) return {true, fmt::format("{}: {}", script, said)};
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {true, fmt::format("{}: {} failed", script, program)};
  return {};
}

std::string gnuplot_version(const std::filesystem::path& folder, const std::string& program) {
  const std::string script = ".gnuplot-version.gp", answer = ".gnuplot-version.txt";
  std::ofstream(folder / script) << "set print '" << answer << "'\n"
                                 << "print sprintf('%g.%s', GPVAL_VERSION, GPVAL_PATCHLEVEL)\n";
  std::string version;
  if (run_gnuplot(folder, script, program).problem.empty()) {
    std::ifstream stream(folder / answer);
    std::getline(stream, version);
  }
  std::error_code ignored;
  for (const std::string& file : {script, answer}) std::filesystem::remove(folder / file, ignored);
  return version;
}

}  // namespace kappabench
