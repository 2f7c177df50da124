#pragma once

#include <span>
#include <vector>

#include "metrics/arc_map.hpp"
#include "metrics/metric.hpp"
#include "metrics/node_pieces.hpp"
#include "schemes/curve/certification.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// The label of a number that is as certain as this.
[[nodiscard]] Method method_of(Certification certification);

/// A point of the curvature plot between which and the next the curvature is monotone.
struct ProfilePoint {
  enum class Kind { end, extremum, cusp };
  CurvePlace place;
  double curvature;  ///< one-sided at a joint and at a cusp, where it is infinite
  Kind kind;
  double error = 0.0;  ///< how much of the curvature rounding of the coordinates explains
};

/// The curvature of a curve as a sequence of monotone stretches: both ends of every segment and the extrema inside.
/// A joint is two points, one a side, so a jump of curvature is one more (vertical) stretch.
struct CurvatureProfile {
  std::vector<ProfilePoint> points;
  std::vector<std::size_t> first;                      ///< of each segment; one more at the end
  Certification certification = Certification::exact;  ///< of the extrema and cusps inside all segments
  double unit = 0.0;                                   ///< 1 / length of the curve: curvature far below it is none
  double known_to = 0.0;                               ///< a length: as curvature_profile() was told
  double range = 0.0;                                  ///< largest minus smallest curvature, cusps left out

  [[nodiscard]] std::span<const ProfilePoint> of_segment(int segment) const;
  /// Extrema and cusps inside a segment: where to split quadrature.
  [[nodiscard]] std::vector<double> splits(int segment) const;
  [[nodiscard]] bool cusp_within(int segment, double t0, double t1) const;
};

/// Never throws. Curvature at an end of a segment where the speed vanishes is taken at 1e-6 inside.
/// Extrema within 1e-6 of a cusp are the cusp's rounding, and left out. `known_to`, a length: what the coordinates of
/// the drawing are rounded to (rounding_of).
[[nodiscard]] CurvatureProfile curvature_profile(const Curve& curve, double known_to);

/// The profile within these stretches, one after the other, with the curvature at both ends of each.
[[nodiscard]] std::vector<ProfilePoint> profile_within(const Curve& curve, const CurvatureProfile& profile,
                                                       std::span<const Part> parts);

/// A local maximum or minimum of a sequence of curvatures.
struct TurningPoint {
  std::size_t index;  ///< into the sequence
  bool maximum;
};

/// The turning points inside an open sequence: where it rises and then falls, or falls and then rises. A reversal
/// counts if it is larger than `prominence`, than the errors of both curvatures, and than 1e-9 of the curvature there
/// or of `unit`, whichever is larger: smaller ones are the rounding of control points. The two ends are not turning
/// points.
[[nodiscard]] std::vector<TurningPoint> turning_points(std::span<const ProfilePoint> sequence, double unit,
                                                       double prominence = 0.0);

/// The turning points of a whole curve, closed ones taken around. Indices are into profile.points, in no order.
[[nodiscard]] std::vector<TurningPoint> turning_points(const CurvatureProfile& profile, bool closed,
                                                       double prominence = 0.0);

}  // namespace kappabench
