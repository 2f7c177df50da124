#pragma once

#include <stdexcept>

namespace kappabench {

/// The exit statuses of the program: a contract, scripts depend on them.
enum ExitStatus : int { success = 0, bad_usage = 2, ran_and_failed = 3 };

/// Wrong arguments or input: one line that says what, where and what would be right. Exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace kappabench
