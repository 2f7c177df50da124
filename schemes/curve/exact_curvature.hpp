#pragma once

#include <vector>

#include "schemes/curve/segment.hpp"
#include "schemes/numerics/root_isolation.hpp"

namespace kappabench {

/// Where a function of a segment's parameter changes sign in the open interval (0, 1).
struct SignChanges {
  /// Ascending. A stretch on which the function is 0 between opposite signs is one bracket.
  std::vector<RootBracket> at;
  /// True: the number of brackets is proved for the segment's defining numbers, taken as exact.
  /// False: found by sampling, so a close pair may be missed.
  bool certified = true;
  /// The function is 0 up to the rounding of the defining numbers (a straight line, a circular arc); `at` is empty.
  bool vanishes = false;
};

/// Extrema of the signed curvature inside the segment: sign changes of d kappa / dt.
///
/// Polynomial and trigonometric segments: a polynomial of degree 4k - 7 (k the degree) or 14 in the half-angle
/// tangent, isolated in double precision with rounding bounds and, where that is undecided, in integers. Curvature
/// as a B-spline: the exact polynomial of every knot span. Clothoids have none, those of elliptical arcs are known in
/// closed form. Blends and opaque segments are sampled at 257 parameters. A cusp (a zero of c') shows as an extremum,
/// too: the sign of d kappa / dt changes there.
/// Never throws; a segment with numbers that are not finite has none.
[[nodiscard]] SignChanges curvature_extrema(const Segment& segment);

/// Sign changes of the curvature inside the segment, by the same means. At a cusp of a cubic there is none.
[[nodiscard]] SignChanges inflections(const Segment& segment);

/// Parameters in (0, 1) where the segment stops: local minima of the speed below 1e-8 of the mean speed. Rounding
/// of the control points opens a cusp to such a minimum. Blends and opaque segments: as above, from 257 samples.
[[nodiscard]] std::vector<double> cusps(const Segment& segment);

}  // namespace kappabench
