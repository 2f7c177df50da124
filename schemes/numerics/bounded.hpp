#pragma once

#include <cmath>
#include <limits>

namespace kappabench {

/// A double with a rigorous bound of how far rounding has carried it from the exact result: the exact value lies in
/// [value - error, value + error]. Much faster than interval arithmetic with switched rounding modes, and enough to
/// certify a sign. Overflow gives an undecided sign, never a wrong one.
struct Bounded {
  double value = 0.0;
  double error = 0.0;

  Bounded() = default;
  Bounded(double exact) : value(exact) {}  // NOLINT(google-explicit-constructor): a double is an exact number
  Bounded(int exact) : value(exact) {}     // NOLINT(google-explicit-constructor)
  Bounded(double v, double e) : value(v), error(e) {}

  /// The certified sign: 1, -1, or 0 for "undecided" (also when the exact value is 0).
  [[nodiscard]] int sign() const {
    if (!(std::abs(value) > error) || !std::isfinite(value)) return 0;
    return value > 0.0 ? 1 : -1;
  }
};

namespace detail {
inline constexpr double half_ulp = 0x1p-53;
/// Covers the rounding of the few operations that compute a bound.
inline constexpr double inflate = 1.0 + 0x1p-49;
}  // namespace detail

[[nodiscard]] inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const double v = a.value + b.value;
  return {v, (a.error + b.error + detail::half_ulp * std::abs(v)) * detail::inflate};
}

[[nodiscard]] inline Bounded operator-(const Bounded& a, const Bounded& b) {
  const double v = a.value - b.value;
  return {v, (a.error + b.error + detail::half_ulp * std::abs(v)) * detail::inflate};
}

[[nodiscard]] inline Bounded operator*(const Bounded& a, const Bounded& b) {
  const double v = a.value * b.value;
  const double e = std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error +
                   detail::half_ulp * std::abs(v) + std::numeric_limits<double>::min();  // the last: underflow
  return {v, e * detail::inflate};
}

inline Bounded& operator+=(Bounded& a, const Bounded& b) { return a = a + b; }

}  // namespace kappabench
