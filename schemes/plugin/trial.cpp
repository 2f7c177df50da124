#include "schemes/plugin/trial.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace kappabench {

namespace {

using Clock = std::chrono::steady_clock;

/// Writes all of it, or as much as somebody reads.
void write_all(int to, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(to, text.data(), text.size());
    if (written < 0 && errno != EINTR) return;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// The child. Its answer ends with a zero byte: one that only ends has told nothing.
[[noreturn]] void try_and_exit(int answer, const std::function<std::string()>& work) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  write_all(answer, work() + '\0');
  _exit(0);
}

/// What comes through until the other end closes or the time is over.
std::string read_until(int from, Clock::time_point deadline) {
  std::string text;
  std::array<char, 4096> block{};
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd watched{from, POLLIN, 0};
    if (left <= 0) return text;
    if (poll(&watched, 1, static_cast<int>(left)) <= 0) continue;
    const ssize_t count = read(from, block.data(), block.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
    if (text.ends_with('\0')) return text;
  }
}

int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string trial(std::chrono::seconds most, const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "no process");
  if (child == 0) try_and_exit(ends[1], work);
  close(ends[1]);
  const auto deadline = Clock::now() + most;
  std::string answer = read_until(ends[0], deadline);
  close(ends[0]);
  const bool late = Clock::now() >= deadline;
  if (!answer.ends_with('\0')) kill(child, SIGKILL);
  const int status = status_of(child);
  if (answer.ends_with('\0')) return answer.substr(0, answer.size() - 1);
  if (late) return fmt::format("took longer than {} s when it was tried", most.count());
  if (WIFSIGNALED(status)) return fmt::format("crashed when it was tried ({})", strsignal(WTERMSIG(status)));
  return fmt::format("ended the process when it was tried (status {})", WEXITSTATUS(status));
}

}  // namespace kappabench
