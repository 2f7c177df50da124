#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace kappabench {

/// A program to be run: words[0] is a file of `folder`, or a program in PATH. It runs in `folder`, an absolute path.
struct Command {
  std::vector<std::string> words;
  std::filesystem::path folder;
};

/// What a question may cost.
struct Allowance {
  double seconds;     ///< from the question to the end of the answer; the start of the program is within
  std::size_t bytes;  ///< of the answer's line
};

/// What came of a question.
struct Reply {
  enum class End {
    answered,
    not_started,  ///< the system cannot run the program
    ended,        ///< the program ended, or closed its output, before the end of the line
    overlong,     ///< more than the allowed bytes without an end of line
    timed_out
  };
  End end;
  std::string line{};     ///< the answer, without the end of the line
  std::string why{};      ///< of what is no answer, in a few words: "exited with status 1"
  std::string stderr_{};  ///< what it last said there, made one printable line of at most 400 bytes
};

/// A program that is asked on its standard input and answers on its standard output, a line each. It is started at the
/// first question, asked many times, and started anew after every reply but an answer. The first line is the answer; a
/// program that writes more than it is not asked again but started anew. Blank lines are nothing.
///
/// The program and what it starts are a process group, which ends with this object, and with this process however it
/// ends; only what leaves the group on purpose (setsid) survives. Safe to use from several threads, which take turns;
/// after a fork the child has a program of its own. Forking while another thread asks is not safe.
class Process {
 public:
  explicit Process(Command command);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// `question` is one line, its end included. Never throws but std::bad_alloc.
  [[nodiscard]] Reply ask(const std::string& question, const Allowance& allowance);

 private:
  class Child;
  using Deadline = std::chrono::steady_clock::time_point;

  [[nodiscard]] Reply ask_child(const std::string& question, Deadline deadline, std::size_t most_bytes);

  Command command_;
  std::mutex turn_;
  std::unique_ptr<Child> child_;
  pid_t owner_ = 0;  ///< the process that started it: after a fork, the parent
};

}  // namespace kappabench
