#pragma once

#include <span>
#include <vector>

#include "schemes/curve/vec.hpp"

namespace kappabench::pkappa {

/// The mean of the two chords at a point of a drawing: the length that the segment through it has to bridge. The point
/// is no end of an open drawing.
[[nodiscard]] inline double chord_at(std::span<const Vec2> points, std::size_t point) {
  const std::size_t n = points.size();
  const Vec2 &before = points[(point + n - 1) % n], &here = points[point], &after = points[(point + 1) % n];
  return 0.5 * ((here - before).norm() + (after - here).norm());
}

/// Of every point that a segment passes: all but the ends of an open drawing.
[[nodiscard]] inline std::vector<double> chords_of(std::span<const Vec2> points, bool closed) {
  const std::size_t skip = closed ? 0 : 1;
  std::vector<double> chords;
  for (std::size_t i = skip; i + skip < points.size(); ++i) chords.push_back(chord_at(points, i));
  return chords;
}

}  // namespace kappabench::pkappa
