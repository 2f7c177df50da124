#pragma once

#include <optional>
#include <vector>

#include "schemes/api/input.hpp"

namespace kappabench::euler_spiral {

/// The polygon of the points: all that the shape of the spline depends on. Chord k leads from point k to the next one.
struct Polygon {
  std::vector<double> lengths;     ///< of the chords
  std::vector<double> directions;  ///< of the chords, against the x axis, radians
  std::vector<double> turns;       ///< at point k, from chord k - 1 to chord k, in [-pi, pi]; 0 at open ends
  bool closed;
  std::optional<double> start{}, end{};  ///< headings given at open ends, against the first and the last chord

  [[nodiscard]] std::size_t points() const { return turns.size(); }
  [[nodiscard]] std::size_t chords() const { return lengths.size(); }
  /// The chord that ends at point k, or at a closed polygon's point 0 the last one.
  [[nodiscard]] std::size_t before(std::size_t k) const { return (k + chords() - 1) % chords(); }
};

/// Where the legs turn straight back, to rounding, the points do not say to which side: it is that to which the two
/// neighbours turn together, left if they do not.
[[nodiscard]] Polygon polygon_of(const Input& input);

/// The unknowns: the heading at each point against the bisector of its two legs, which is half of the turn off each of
/// them (at an open end, against its leg). So nothing depends on the direction of travel.
using Headings = std::vector<double>;

/// Those of the circles through each point and its neighbours; at open ends of the circle of the next point, or given.
[[nodiscard]] Headings circle_headings(const Polygon& polygon);

}  // namespace kappabench::euler_spiral
