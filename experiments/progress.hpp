#pragma once

#include <string>
#include <string_view>

namespace kappabench {

/// A bar on stderr, drawn only when stderr is a terminal; silent otherwise.
class Progress {
 public:
  Progress(std::string what, int total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more of the total is done; `last` names it.
  void step(std::string_view last);

 private:
  void draw(std::string_view last) const;

  std::string what_;
  int total_;
  int done_ = 0;
  bool terminal_;
};

}  // namespace kappabench
