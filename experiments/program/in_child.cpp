#include "experiments/program/in_child.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "experiments/program/errors.hpp"

namespace kappabench {

namespace {

/// What the verb throws is a line, as the command line would print it.
int status_of(const std::function<int()>& verb) {
  try {
    return verb();
  } catch (const std::exception& error) {
    fmt::print(stderr, "kappabench: {}\n", error.what());
    return bad_usage;
  }
}

}  // namespace

int in_child(std::string_view what, const std::function<int()>& verb) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (child == 0) {
    const int status = status_of(verb);
    std::fflush(nullptr);
    _exit(status);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  fmt::print(stderr, "kappabench: {}: crashed: {}\n", what, strsignal(WTERMSIG(status)));
  return ran_and_failed;
}

}  // namespace kappabench
