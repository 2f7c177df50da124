#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "schemes/curve/vec.hpp"

namespace kappabench {

/// Random numbers that are the same with every standard library: mt19937_64, whose output the C++ standard fixes,
/// under our own maps, because the standard leaves those of std::*_distribution open.
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// In [least, most), from the upper 53 bits of one draw.
  [[nodiscard]] double uniform(double least, double most) {
    return least + (most - least) * (static_cast<double>(engine_() >> 11U) * 0x1.0p-53);
  }

  /// Standard normal, by Box and Muller 1958 from two draws.
  [[nodiscard]] double normal() {
    const double radius = std::sqrt(-2.0 * std::log1p(-uniform(0.0, 1.0)));
    return radius * std::cos(uniform(0.0, 2.0 * std::numbers::pi));
  }

  /// exp of a uniform number between log(least) and log(most).
  [[nodiscard]] double log_uniform(double least, double most) {
    return std::exp(uniform(std::log(least), std::log(most)));
  }

 private:
  std::mt19937_64 engine_;
};

/// Rounded to multiples of 2^-30: sine, logarithm and the like may differ between mathematics libraries in the last
/// bit, and this hides it but for about one coordinate in 10^6.
[[nodiscard]] inline Vec2 on_grid(const Vec2& point) {
  const auto round = [](double x) { return std::nearbyint(x * 0x1.0p30) * 0x1.0p-30 + 0.0; };
  return {round(point.x()), round(point.y())};
}

}  // namespace kappabench
