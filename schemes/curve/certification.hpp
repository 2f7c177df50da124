#pragma once

#include <algorithm>

namespace kappabench {

/// How a number of sign changes, or of cusps, is known; from the strongest to the weakest.
enum class Certification {
  exact,     ///< proved for the defining numbers, taken as exact: a closed form, or algebraic root isolation
  enclosed,  ///< proved by interval arithmetic, but for places where rounding leaves the sign of the function open
  sampled    ///< from finitely many evaluations: a close pair may be missed
};

/// What is known of both together.
[[nodiscard]] inline Certification weaker(Certification a, Certification b) { return std::max(a, b); }

}  // namespace kappabench
