#pragma once

#include <vector>

#include "schemes/curve/certification.hpp"
#include "schemes/curve/segment.hpp"
#include "schemes/numerics/root_isolation.hpp"

namespace kappabench {

/// Where a function of a segment's parameter changes sign in the open interval (0, 1).
struct SignChanges {
  /// Ascending. A stretch on which the function is 0 between opposite signs is one bracket.
  std::vector<RootBracket> at;
  /// How the number of brackets is known.
  Certification certification = Certification::exact;
  /// The function is 0 up to the rounding of the defining numbers (a straight line, a circular arc); `at` is empty.
  bool vanishes = false;
};

/// Extrema of the signed curvature inside the segment: sign changes of d kappa / dt.
///
/// Exact for polynomial, rational and trigonometric segments (a polynomial of degree 4k - 7, or 9k - 12, k the degree,
/// or 14 in the half-angle tangent, isolated in double precision with rounding bounds and, where that is undecided, in
/// integers), for curvature as a B-spline (the exact polynomial of every knot span), for clothoids, which have none,
/// for elliptical arcs (closed form), and for reparametrisations of these. Enclosed for blends of polynomials, circles,
/// elliptical arcs and their reparametrisations, by interval arithmetic; where that proves nothing, and for opaque
/// and sampled segments, sampled at 257 parameters, or at the samples if they are more. A cusp (a zero of c') shows as
/// an extremum, too: the sign of d kappa / dt changes there. Never throws; a segment with numbers that are not finite
/// has none.
[[nodiscard]] SignChanges curvature_extrema(const Segment& segment);

/// Sign changes of the curvature inside the segment, by the same means. At a cusp of a cubic there is none.
[[nodiscard]] SignChanges inflections(const Segment& segment);

/// Where a segment stops, and how their number is known.
struct Cusps {
  std::vector<double> at;  ///< parameters in (0, 1), ascending
  Certification certification = Certification::exact;
};

/// Local minima of the speed below 1e-8 of the mean speed: rounding of the control points opens a cusp to such a
/// minimum. Certified as extrema are, but sampled where a speed is within a factor of 4 of that limit. A
/// reparametrised segment has those of the other one.
[[nodiscard]] Cusps find_cusps(const Segment& segment);

/// Their parameters alone.
[[nodiscard]] std::vector<double> cusps(const Segment& segment);

}  // namespace kappabench
