#pragma once

#include <vector>

#include "schemes/euler_spiral/polygon.hpp"
#include "schemes/euler_spiral/span.hpp"

namespace kappabench::euler_spiral {

/// A spline, or how far the search for one has come.
struct Solution {
  std::vector<Span> spans;
  double residual;  ///< the largest equation; infinite where the path from small turns has ended early
  double bend;      ///< the part of all turns that is reached, 1 for a spline
  int iterations;   ///< linear solves
  bool continued;   ///< Newton's method alone has not found it
  int other_side;   ///< how many turns are taken to the other side

  /// The longest of all spans, in chords, is where a solution that is none runs away.
  [[nodiscard]] std::size_t longest_span() const;
  /// A span of over 100 chords is a circle that nearly misses its end, as large as its turn is close to 2 pi.
  [[nodiscard]] bool runs_away() const;
  [[nodiscard]] bool is_spline() const;
};

/// Newton's method from the circles, then the path from small turns. Where a span runs away on it, a sharp turn at one
/// of its ends, of over 3/4 pi, is taken to the other side: for two legs that nearly fold back the points hardly say to
/// which. The sharper one, and so on, up to eight turns. If that does not help, the solution is that of the turns as
/// they are.
[[nodiscard]] Solution solution_of(const Polygon& polygon);

}  // namespace kappabench::euler_spiral
