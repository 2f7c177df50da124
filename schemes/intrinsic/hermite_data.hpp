#pragma once

#include <optional>
#include <vector>

#include "schemes/curve/exact_form.hpp"
#include "schemes/numerics/bspline.hpp"

namespace kappabench::intrinsic {

/// Where a curve starts or ends: with a curvature the condition there is G2, without one G1.
struct CurveEnd {
  Vec2 point;
  double heading;                   ///< radians against the x axis
  std::optional<double> curvature;  ///< signed, 1/length
};

/// The two ends of one segment; the points must not coincide.
struct HermiteData {
  CurveEnd from;
  CurveEnd to;
};

/// The same with the start at the origin, its tangent along the x axis and a chord of length 1 (Yoshida 2022, Sect. 4).
/// Headings are taken within half a turn of the chord, so that each angle below is the only one of its kind.
struct StandardData {
  double chord_angle;                     ///< theta_e: of the chord against the start tangent, in (-pi, pi]
  double turning;                         ///< theta_d: of the end tangent against the start tangent
  std::optional<double> start_curvature;  ///< times the chord
  std::optional<double> end_curvature;

  /// Of the end tangent against the chord, theta_d - theta_e, in [-pi, pi).
  [[nodiscard]] double end_angle() const { return turning - chord_angle; }
};

[[nodiscard]] StandardData standard_form(const HermiteData& data);

/// A curvature function and a length that stand in the same form.
struct StandardCurve {
  BSplineBasis basis;
  std::vector<double> controls;  ///< control curvatures times the chord
  double length;                 ///< over the chord
};

/// The same numbers with the start at the origin in direction `angle`, the chord being the unit.
[[nodiscard]] IntrinsicForm form_of(const StandardCurve& curve, double angle);

/// The largest control curvature, without sign: what rounding is relative to.
[[nodiscard]] double largest_control(const StandardCurve& curve);

/// The mirror image in the chord's line turned into the start tangent's: angles and curvatures change sign.
[[nodiscard]] StandardData mirrored(const StandardData& data);
[[nodiscard]] StandardCurve mirrored(StandardCurve curve);

/// The same run from its end to its start. A rising curvature rises again.
[[nodiscard]] StandardData reversed(const StandardData& data);
[[nodiscard]] StandardCurve reversed(StandardCurve curve);

/// The curve put back where the data are.
[[nodiscard]] IntrinsicForm placed(const StandardCurve& curve, const HermiteData& data);

/// How far the curve misses the data: the distance of its end from theirs in chords, plus the difference of the end
/// angles in radians. Curvatures are not looked at: they are the first and last control curvature.
[[nodiscard]] double gap(const StandardCurve& curve, const StandardData& data);

}  // namespace kappabench::intrinsic
