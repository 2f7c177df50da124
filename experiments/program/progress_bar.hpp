#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace kappabench {

/// Progress on stderr with an estimate of the time left. On a terminal a bar as wide as it is, which is gone when the
/// work is; elsewhere, in logs, a line every tenth of the work, none for work of a few seconds.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `done` of `total` are done; `last` names what was done last.
  void show(std::size_t done, std::size_t total, std::string_view last);

  /// `show` as a callback; the bar must outlive it.
  [[nodiscard]] std::function<void(std::size_t, std::size_t, std::string_view)> callback() {
    return [this](std::size_t done, std::size_t total, std::string_view last) { show(done, total, last); };
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  std::size_t tenths_said_ = 0;
};

/// "12 s left", "3 min left", "2 h left": what remains if the rest goes on as the part did. Empty before anything is
/// done.
[[nodiscard]] std::string time_left(std::chrono::duration<double> elapsed, std::size_t done, std::size_t total);

/// One line of at most `width` columns: what, a bar, counts, time left, and as much of `last` as there is room for.
[[nodiscard]] std::string bar_line(std::string_view what, std::size_t done, std::size_t total, std::string_view left,
                                   std::string_view last, std::size_t width);

}  // namespace kappabench
