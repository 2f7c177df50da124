#include "experiments/program/progress_bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "datasets/text.hpp"

namespace kappabench {

namespace {

constexpr std::size_t usual_width = 80;
constexpr std::chrono::seconds short_work{5};

std::size_t terminal_width() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : usual_width;
}

/// The first `width` characters; nothing that a terminal would obey.
std::string clipped(std::string_view text, std::size_t width) {
  std::string clipped;
  for (std::size_t columns = 0; columns < width && !text.empty(); ++columns) {
    const std::string_view before = text;
    const auto character = take_utf8(text);
    if (!character) text.remove_prefix(1);
    const bool printable = character && *character >= 0x20 && *character != 0x7f;
    clipped += printable ? before.substr(0, before.size() - text.size()) : "?";
  }
  return clipped;
}

}  // namespace

std::string time_left(std::chrono::duration<double> elapsed, std::size_t done, std::size_t total) {
  if (done == 0 || done >= total) return {};
  const double seconds = elapsed.count() * static_cast<double>(total - done) / static_cast<double>(done);
  if (seconds < 99.5) return fmt::format("{:.0f} s left", std::ceil(seconds));
  constexpr double minute = 60.0, hour = 3600.0;
  return seconds < 99.5 * minute ? fmt::format("{:.0f} min left", seconds / minute)
                                 : fmt::format("{:.0f} h left", seconds / hour);
}

std::string bar_line(std::string_view what, std::size_t done, std::size_t total, std::string_view left,
                     std::string_view last, std::size_t width) {
  const std::string counts = fmt::format("{}/{}{}{}", done, total, left.empty() ? "" : ", ", left);
  constexpr std::size_t longest_bar = 30, shortest_bar = 5, frame = 4;
  std::string line = clipped(what, width);
  const std::size_t taken = line.size() + frame + counts.size();
  if (taken + shortest_bar <= width) {
    const std::size_t bar = std::min(longest_bar, width - taken);
    const std::size_t filled = bar * std::min(done, total) / std::max<std::size_t>(total, 1);
    line += fmt::format(" [{}{}]", std::string(filled, '#'), std::string(bar - filled, '.'));
  }
  line = clipped(line + " " + counts, width);
  return line.size() + 1 < width ? line + " " + clipped(last, width - line.size() - 1) : line;
}

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(std::size_t done, std::size_t total, std::string_view last) {
  const auto elapsed = Clock::now() - start_;
  const std::string left = time_left(elapsed, done, total);
  if (terminal_) {
    // One column is kept free: a full line would wrap.
    fmt::print(stderr, "\r\033[K{}", bar_line(what_, done, total, left, last, terminal_width() - 1));
    std::fflush(stderr);
    return;
  }
  const std::size_t tenths = 10 * done / std::max<std::size_t>(total, 1);
  if (tenths == tenths_said_ || elapsed < short_work) return;
  tenths_said_ = tenths;
  fmt::print(stderr, "kappabench: {}: {} % ({} of {}){}{}\n", what_, 10 * tenths, done, total, left.empty() ? "" : ", ",
             left);
}

}  // namespace kappabench
