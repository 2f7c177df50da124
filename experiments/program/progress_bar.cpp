#include "experiments/program/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace kappabench {

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(std::size_t done, std::size_t total, std::string_view last) const {
  if (!terminal_) return;
  constexpr std::size_t width = 30;
  const std::size_t filled = width * std::min(done, total) / std::max<std::size_t>(total, 1);
  fmt::print(stderr, "\r\033[K{} [{}{}] {}/{} {:.40}", what_, std::string(filled, '#'),
             std::string(width - filled, '.'), done, total, last);
  std::fflush(stderr);
}

}  // namespace kappabench
