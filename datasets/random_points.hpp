#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "datasets/drawing.hpp"

namespace kappabench {

/// Families of random point sequences, each a different difficulty, all scaled to a mean chord of 1. Lengths below are
/// before that last scaling, which changes little.
enum class RandomKind {
  /// A walk of steps 0.5 to 1.5 that turns by normal angles (standard deviation 0.6 rad). Closed: the end is led
  /// back to the start by a drift shared by all steps.
  walk,
  /// Seen from the middle every point lies in its own direction, up to 0.7 off a circle on which points are 1 apart:
  /// a blob with dents. Open: the same without the last chord.
  star,
  /// Sharp alternating turns: amplitudes 0.3 to 1.5 on the two sides of a line, or of a circle if closed.
  zigzag,
  /// Points on a gentle blob whose chords differ up to 1000 times, log-uniformly. Open: three quarters of it.
  uneven,
  /// Straight runs of about five points that deviate from the line by 1e-3 of a chord, with corners between.
  /// Closed: the sides of a regular polygon.
  near_collinear,
  /// Points about 1 apart with 5 % jitter on a spiral of Archimedes whose arms are 2 apart. Closed: out on one arm and
  /// back on another between.
  spiral
};

/// All of them, in the order above.
[[nodiscard]] const std::vector<RandomKind>& random_kinds();

/// "walk", "star", "zigzag", "uneven", "near-collinear", "spiral".
[[nodiscard]] std::string_view name(RandomKind kind);

/// `n` >= 1 points. Depends on nothing but the arguments, bit for bit on one platform and, because coordinates are
/// rounded to multiples of 2^-30, nearly always across platforms. Throws std::invalid_argument if n < 1.
[[nodiscard]] Input random_input(RandomKind kind, int n, std::uint64_t seed, bool closed);

/// "random:KIND[:n=12,seed=1,closed=false,count=1]": `count` drawings of one curve, with seed, seed + 1, ...
/// Throws DataError.
[[nodiscard]] std::vector<Drawing> random_drawings(std::string_view name);

}  // namespace kappabench
