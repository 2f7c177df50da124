#include "schemes/plugin/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/select.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "schemes/plugin/one_line.hpp"

#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

namespace kappabench {

namespace {

using Clock = std::chrono::steady_clock;

/// A file descriptor that is closed in time.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool open() const { return number_ >= 0; }
  void close() {
    if (open()) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

[[noreturn]] void refuse(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

struct Pipe {
  Descriptor read, write;
};

/// Another one for the same end: closed by exec, and out of the way of the standard streams, which may be closed here.
Descriptor out_of_the_way(const Descriptor& end) {
  const int moved = fcntl(end.number(), F_DUPFD_CLOEXEC, 8);
  if (moved < 0) refuse("no file descriptors left");
  return Descriptor(moved);
}

Pipe make_pipe() {
  std::array<int, 2> ends{};
#ifdef __linux__
  const int failed = pipe2(ends.data(), O_CLOEXEC);
#else
  const int failed = pipe(ends.data());
#endif
  if (failed != 0) refuse("no pipe");
  const Descriptor read_end(ends[0]), write_end(ends[1]);
  return {out_of_the_way(read_end), out_of_the_way(write_end)};
}

void do_not_wait(const Descriptor& end) { fcntl(end.number(), F_SETFL, fcntl(end.number(), F_GETFL) | O_NONBLOCK); }

/// What the program's guardian tells us, once or twice.
struct News {
  enum What : int { cannot_run, ended } what;
  int value;  ///< errno, or a status as waitpid gives it
};

// ---- in the guardian and the program, where only what is safe in a signal handler may be called

struct Started {
  const char* program;
  const char* folder;
  char* const* arguments;
  int in, out, err, news, life;
};

void tell(int news, News what) { static_cast<void>(!write(news, &what, sizeof what)); }

void on_child(int) {}

[[noreturn]] void become_program(const Started& started) {
  setpgid(0, 0);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // if it is the guardian that dies first
#endif
  for (int signal_number = 1; signal_number < 32; ++signal_number) signal(signal_number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(started.in, STDIN_FILENO);
  dup2(started.out, STDOUT_FILENO);
  dup2(started.err, STDERR_FILENO);
  if (chdir(started.folder) == 0) execv(started.program, started.arguments);
  tell(started.news, {News::cannot_run, errno});
  _exit(127);
}

void close_from(int first) {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, 0U) == 0) return;
#endif
  for (int number = first; number < 65536; ++number) close(number);
}

/// A small process between us and the program: when either ends, it ends the program's group, and tells how the program
/// ended. Why not PR_SET_PDEATHSIG alone: that means the death of the thread that forked, and spares grandchildren.
[[noreturn]] void become_guardian(const Started& started) {
  setpgid(0, 0);  // a Ctrl-C is meant for us, who end it then
  struct sigaction action {};
  action.sa_handler = on_child;
  action.sa_flags = SA_NOCLDSTOP;
  sigaction(SIGCHLD, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
  sigset_t children, none;
  sigemptyset(&none);
  sigemptyset(&children);
  sigaddset(&children, SIGCHLD);
  sigprocmask(SIG_SETMASK, &children, nullptr);  // SIGCHLD comes in pselect and nowhere else

  const pid_t program = fork();
  if (program == 0) become_program(started);
  if (program < 0) tell(started.news, {News::cannot_run, errno}), _exit(0);
  setpgid(program, program);  // both do it: neither can know who is first
  constexpr int life = 3, news = 4;
  dup2(started.life, life);
  dup2(started.news, news);
  close(STDIN_FILENO), close(STDOUT_FILENO), close(STDERR_FILENO);
  close_from(news + 1);

  fd_set watched;
  do {
    FD_ZERO(&watched);
    FD_SET(life, &watched);
  } while (pselect(life + 1, &watched, nullptr, nullptr, nullptr, &none) < 0 && errno != EINTR);
  kill(-program, SIGKILL);  // before it is waited for, that is, while its number is surely its own
  int status = 0;
  while (waitpid(program, &status, 0) < 0 && errno == EINTR) {
  }
  tell(news, {News::ended, status});
  _exit(0);
}

// ---- here

/// The file that a command names; empty if there is none.
std::string program_file(const Command& command) {
  const std::string& word = command.words.front();
  const auto is_file = [](const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
  };
  if (const auto beside = command.folder / word; is_file(beside)) return beside.string();
  const char* path = std::getenv("PATH");
  if (path == nullptr || word.find('/') != std::string::npos) return {};
  for (std::string_view rest = path; !rest.empty();) {
    const std::size_t colon = rest.find(':');
    const auto file = std::filesystem::path(rest.substr(0, colon)) / word;
    rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
    if (is_file(file) && access(file.c_str(), X_OK) == 0) return std::filesystem::absolute(file).string();
  }
  return {};
}

std::string words_of(const News& news) {
  if (news.what == News::cannot_run)
    return fmt::format("{}{}", std::strerror(news.value),
                       news.value == ENOEXEC  ? "; a script begins with a line like #!/usr/bin/env python3"
                       : news.value == EACCES ? "; make it executable, or name its interpreter first"
                                              : "");
  if (WIFSIGNALED(news.value)) return fmt::format("was ended by signal {}", strsignal(WTERMSIG(news.value)));
  return fmt::format("exited with status {}", WEXITSTATUS(news.value));
}

/// Holds back the SIGPIPE of a write in this thread, whatever the process does about that signal.
class NoSigpipe {
 public:
  NoSigpipe() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pending_before_ = pending();
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoSigpipe(const NoSigpipe&) = delete;
  NoSigpipe& operator=(const NoSigpipe&) = delete;
  ~NoSigpipe() {
    int taken = 0;
    if (!pending_before_ && pending()) sigwait(&pipe_, &taken);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  static bool pending() {
    sigset_t set;
    sigpending(&set);
    return sigismember(&set, SIGPIPE) == 1;
  }
  sigset_t pipe_{}, before_{};
  bool pending_before_ = false;
};

/// Milliseconds for poll, rounded up; 0 when the time is over.
int milliseconds_to(Clock::time_point deadline) {
  const double left = std::chrono::duration<double, std::milli>(deadline - Clock::now()).count();
  return static_cast<int>(std::ceil(std::clamp(left, 0.0, 1e6)));
}

constexpr std::size_t stderr_kept = 4096;

}  // namespace

/// The running program, as seen from here.
class Process::Child {
 public:
  /// Throws std::system_error if there is no room for another process.
  explicit Child(const Command& command) {
    std::string program = program_file(command), folder = command.folder.string();
    if (program.empty()) program = command.words.front();  // the system says what is wrong with it
    std::vector<std::string> words = command.words;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    Pipe in = make_pipe(), out = make_pipe(), err = make_pipe(), news = make_pipe(), life = make_pipe();
    guardian_ = fork();
    if (guardian_ < 0) refuse("no process");
    if (guardian_ == 0)
      become_guardian({program.c_str(), folder.c_str(), arguments.data(), in.read.number(), out.write.number(),
                       err.write.number(), news.write.number(), life.read.number()});
    in_ = std::move(in.write);
    out_ = std::move(out.read);
    err_ = std::move(err.read);
    news_ = std::move(news.read);
    life_ = std::move(life.write);
    for (const Descriptor* end : {&in_, &out_, &err_}) do_not_wait(*end);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { end(); }

  /// Ends the program and all that it started.
  void end() {
    life_.close();
    while (guardian_ > 0 && waitpid(guardian_, nullptr, 0) < 0 && errno == EINTR) {
    }
    guardian_ = 0;
  }

  /// After a fork it is the parent's.
  void leave_alone() { guardian_ = 0; }

  /// Ended between two questions, or said something that it was not asked.
  [[nodiscard]] bool unusable() const {
    pollfd watched{out_.number(), POLLIN, 0};
    return poll(&watched, 1, 0) != 0;
  }

  [[nodiscard]] Reply converse(const std::string& question, Deadline deadline, std::size_t most_bytes) {
    std::size_t written = 0;
    std::string heard;
    while (true) {
      // A descriptor of -1 is passed over.
      std::array<pollfd, 3> watched{{{out_.number(), POLLIN, 0},
                                     {err_.number(), POLLIN, 0},
                                     {written < question.size() ? in_.number() : -1, POLLOUT, 0}}};
      const int wait = milliseconds_to(deadline);
      if (wait == 0) return {.end = Reply::End::timed_out};
      if (poll(watched.data(), watched.size(), wait) < 0 && errno != EINTR) refuse("poll");
      if (watched[1].revents != 0) hear_stderr();
      if (watched[2].revents != 0) written = write_some(question, written);
      if (watched[0].revents == 0) continue;
      if (!read_some(out_, heard)) return closed(deadline);
      if (const std::size_t first = heard.find_first_not_of(" \t\r\n"); first == std::string::npos) {
        heard.clear();
      } else if (const std::size_t stop = heard.find('\n', first); stop != std::string::npos) {
        said_more_ = heard.find_first_not_of(" \t\r\n", stop) != std::string::npos;
        if (stop - first <= most_bytes) return {.end = Reply::End::answered, .line = heard.substr(first, stop - first)};
      }
      if (heard.size() > most_bytes) return {.end = Reply::End::overlong};
    }
  }

  /// Wrote more than an answer.
  [[nodiscard]] bool said_more() const { return said_more_; }

  /// Of a program that has ended.
  [[nodiscard]] std::string last_words() {
    hear_stderr();
    return one_line_of_tail(stderr_);
  }

 private:
  /// Appends what there is; false at the end of the stream.
  static bool read_some(const Descriptor& from, std::string& to) {
    std::array<char, 65536> buffer;  // NOLINT(cppcoreguidelines-pro-type-member-init): read fills what is used
    const ssize_t got = read(from.number(), buffer.data(), buffer.size());
    if (got > 0) to.append(buffer.data(), static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
  }

  /// Takes what the pipe holds and keeps the end of it.
  void hear_stderr() {
    if (!err_.open()) return;
    if (!read_some(err_, stderr_)) err_.close();
    if (stderr_.size() > 2 * stderr_kept) stderr_.erase(0, stderr_.size() - stderr_kept);
  }

  /// How much of the question is written then. What the program does not want to read it need not.
  [[nodiscard]] std::size_t write_some(const std::string& question, std::size_t written) {
    const NoSigpipe guard;
    const ssize_t more = write(in_.number(), question.data() + written, question.size() - written);
    if (more >= 0) return written + static_cast<std::size_t>(more);
    return errno == EAGAIN || errno == EINTR ? written : question.size();
  }

  /// The output has ended before the answer.
  [[nodiscard]] Reply closed(Deadline deadline) {
    const auto soon = std::min(deadline, Clock::now() + std::chrono::milliseconds(500));
    pollfd watched{news_.number(), POLLIN, 0};
    if (poll(&watched, 1, std::max(50, milliseconds_to(soon))) <= 0)
      return {.end = Reply::End::ended, .why = "closed its standard output"};
    News news{};
    if (read(news_.number(), &news, sizeof news) != static_cast<ssize_t>(sizeof news))
      return {.end = Reply::End::ended, .why = "was ended from outside"};
    if (news.what == News::cannot_run) return {.end = Reply::End::not_started, .why = words_of(news)};
    return {.end = Reply::End::ended, .why = words_of(news)};
  }

  Descriptor in_, out_, err_, news_;
  Descriptor life_;  ///< nothing is written there: its end is the guardian's sign that we are gone
  pid_t guardian_ = 0;
  std::string stderr_;
  bool said_more_ = false;
};

Process::Process(Command command) : command_(std::move(command)) {}

Process::~Process() {
  if (child_ && owner_ != getpid()) child_->leave_alone();
}

Reply Process::ask_child(const std::string& question, Deadline deadline, std::size_t most_bytes) {
  try {
    if (!child_) child_ = std::make_unique<Child>(command_);
    Reply reply = child_->converse(question, deadline, most_bytes);
    if (reply.end != Reply::End::answered) {
      child_->end();
      reply.stderr_ = child_->last_words();
    }
    if (reply.end != Reply::End::answered || child_->said_more()) child_.reset();
    return reply;
  } catch (const std::system_error& error) {
    child_.reset();
    return {.end = Reply::End::not_started, .why = error.what()};
  }
}

Reply Process::ask(const std::string& question, const Allowance& allowance) {
  const std::lock_guard lock(turn_);
  const Deadline deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(allowance.seconds));
  if (child_ && owner_ != getpid()) {
    child_->leave_alone();
    child_.reset();
  }
  owner_ = getpid();
  if (child_ && child_->unusable()) child_.reset();
  const bool asked_before = child_ != nullptr;
  Reply reply = ask_child(question, deadline, allowance.bytes);
  // A program may answer once and end; whether it had time to end before this question is chance.
  if (asked_before && reply.end == Reply::End::ended && reply.why == words_of({News::ended, 0}))
    reply = ask_child(question, deadline, allowance.bytes);
  return reply;
}

}  // namespace kappabench
