#pragma once

#include <string_view>

namespace kappabench {

/// The counter of a fit whose `seconds` are another process's, wall time measured there (schemes/plugin): Scheme::fit
/// leaves them as they are, and processor time of this process says nothing about them.
inline constexpr std::string_view timed_outside = "external";

}  // namespace kappabench
