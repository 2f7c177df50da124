#pragma once

#include <string>
#include <string_view>

#include "schemes/api/fit.hpp"

namespace kappabench {

/// The counter of a fit whose `seconds` are wall time of another process (schemes/plugin): Scheme::fit leaves them as
/// they are, and processor time of this process says nothing about them.
inline constexpr std::string_view timed_outside = "external";

[[nodiscard]] inline bool is_timed_outside(const Report& report) {
  return report.counters.contains(std::string(timed_outside));
}

}  // namespace kappabench
