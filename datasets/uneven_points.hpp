#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "schemes/api/input.hpp"

namespace kappabench {

/// Families of random drawings as engineers bring them, in which one length does not fit all spans, and gentle ones to
/// hold against them. Size and number of points are random too.
enum class UnevenKind {
  /// A four-digit NACA section, open or closed at its sharp trailing edge, 8 to 40 points a side in cosine spacing, so
  /// that chords differ up to hundredfold.
  airfoil,
  /// A gentle closed oval of 8 to 40 points with slight noise and uneven spacing.
  ring,
  /// An open walk of 5 to 24 points with turns up to 17 to 74 degrees; chords log-uniform over a ratio of 3 to 1000.
  walk,
  /// Straight sides of 5 to 300 joined by one to three corners that are rounded with a radius of 1 to 3 in one to
  /// three chords.
  corner,
  /// There and back along two parallel rows, 0.05 to 0.6 chords apart.
  hairpin,
  /// A walk of 10 points closed by one long chord.
  long_chord
};

/// All of them, in the order above.
[[nodiscard]] const std::vector<UnevenKind>& uneven_kinds();

/// "airfoil", "ring", "walk", "corner", "hairpin", "long chord".
[[nodiscard]] std::string_view name(UnevenKind kind);

/// Depends on nothing but the arguments.
[[nodiscard]] Input uneven_input(UnevenKind kind, std::uint64_t seed);

}  // namespace kappabench
