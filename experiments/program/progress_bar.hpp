#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace kappabench {

/// A bar on stderr, drawn only when stderr is a terminal and gone when the work is; silent otherwise.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `done` of `total` are done; `last` names what was done last.
  void show(std::size_t done, std::size_t total, std::string_view last) const;

  /// `show` as a callback; the bar must outlive it.
  [[nodiscard]] std::function<void(std::size_t, std::size_t, std::string_view)> callback() const {
    return [this](std::size_t done, std::size_t total, std::string_view last) { show(done, total, last); };
  }

 private:
  std::string what_;
  bool terminal_;
};

}  // namespace kappabench
