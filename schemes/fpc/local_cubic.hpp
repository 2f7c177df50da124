#pragma once

#include <array>

#include "schemes/api/input.hpp"

namespace kappabench::fpc {

/// What is asked of the segment of one point: its type and where on the segment the point lies. Parameters are those
/// of the segment, 0 < t < 1.
struct PointTask {
  PointType type = PointType::regular;
  double t = 0.5;   ///< Chen 2019, Eq. (20)
  double t1 = 0.5;  ///< of a loop, where the segment passes the point first, Eq. (21)
  double t2 = 0.5;  ///< and second
  double h = 0.5;   ///< of an inflection, Eq. (10): the second root of the curvature's numerator is t + 2h
};

/// The h at which an inflection at t has no solution: then t(t - 1) + 2h(2t - 1) = 0, and the three linear conditions
/// of the segment are dependent. Infinite at t = 1/2. Always inside the range that the paper allows.
[[nodiscard]] double singular_h(double t);

/// Whether h keeps the second inflection out of the segment: h < -t/2 or h > (1 - t)/2.
[[nodiscard]] bool admissible_h(double t, double h);

/// Appendix B of Chen 2019, M_1 to M_6 of one point. With X and Y the joints before and behind the point, both minus
/// the point, the segment's velocity is M_3 X + M_4 Y at its start and -(M_1 X + M_2 Y) at its end;
/// M_5 = M_1 + M_2 and M_6 = M_3 + M_4.
[[nodiscard]] std::array<double, 6> joint_coefficients(const PointTask& task);

/// The cubic through one point with the asked feature, as a linear function of X and Y. All cross products on it are
/// multiples of the area T = X x Y, so that the numerator of its curvature, (Q' x Q'')/2, is a fixed quadratic
/// polynomial times T: the sign of T alone decides which way the segment turns.
struct LocalCubic {
  PointTask task;
  double start_x, start_y;  ///< velocity at t = 0 is start_x X + start_y Y
  double end_x, end_y;      ///< velocity at t = 1
  double start_numerator;   ///< (Q' x Q'')/2 at t = 0, over T
  double end_numerator;     ///< the same at t = 1

  explicit LocalCubic(const PointTask& task);

  [[nodiscard]] Vec2 start_velocity(const Vec2& x, const Vec2& y) const { return start_x * x + start_y * y; }
  [[nodiscard]] Vec2 end_velocity(const Vec2& x, const Vec2& y) const { return end_x * x + end_y * y; }
};

}  // namespace kappabench::fpc
