#pragma once

#include <algorithm>

namespace kappabench::test {

/// Sanitizers take ten times as long and look for other faults: a few cases meet the same code.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// How many of `n` random cases to take.
constexpr int cases(int n) { return sanitized ? std::max(1, n / 8) : n; }

}  // namespace kappabench::test
