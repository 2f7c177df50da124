#include "experiments/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace kappabench {

Progress::Progress(std::string what, int total)
    : what_(std::move(what)), total_(std::max(total, 1)), terminal_(isatty(STDERR_FILENO) == 1) {
  draw("");
}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::step(std::string_view last) {
  done_ = std::min(done_ + 1, total_);
  draw(last);
}

void Progress::draw(std::string_view last) const {
  if (!terminal_) return;
  constexpr int width = 30;
  const auto filled = static_cast<std::size_t>(width * done_ / total_);
  fmt::print(stderr, "\r\033[K{} [{}{}] {}/{} {:.40}", what_, std::string(filled, '#'),
             std::string(width - filled, '.'), done_, total_, last);
  std::fflush(stderr);
}

}  // namespace kappabench
