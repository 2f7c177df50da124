#include "schemes/segments/three_point_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "schemes/numerics/bracketed_newton.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench {

namespace {

using std::numbers::pi;

/// Sine of the angle between two legs below which they count as parallel.
constexpr double parallel_sine = 1e-9;

bool parallel(const Vec2& a, const Vec2& b, double sine) { return std::abs(cross(a, b)) <= sine * a.norm() * b.norm(); }

/// The signed angle from a to b.
double angle_from(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

/// Half the turning of the circle's two halves: by the inscribed angle theorem the angle at the third point.
struct HalfTurns {
  double first, second;
};
HalfTurns half_turns(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  return {angle_from(p0 - p2, p1 - p2), angle_from(p1 - p0, p2 - p0)};
}

/// The circular arc from a to b that turns by twice `half_turn`.
ClothoidForm circular_arc(const Vec2& a, const Vec2& b, double half_turn) {
  const Vec2 chord = b - a;
  const double sine = std::sin(half_turn), length = chord.norm();
  return {.start = a,
          .angle = std::atan2(chord.y(), chord.x()) - half_turn,
          .curvature = 2.0 * sine / length,
          .curvature_rate = 0.0,
          .length = half_turn == 0.0 ? length : length * half_turn / sine};
}

SegmentPtr line(const Vec2& a, const Vec2& b) { return std::make_shared<PolynomialSegment>(std::array<Vec2, 2>{a, b}); }

/// Directions at the middle point p1: theta from the longer leg to the axis of the ellipse through p1, M the angle
/// between the legs, which the axis splits.
struct AxisDirection {
  double sine, cosine;            ///< of theta
  double rest_sine, rest_cosine;  ///< of M - theta
};

/// The far point lies at (b, a) from p1 along and across the axis, a = l1 sin theta, b = l1 cos theta, and the near one
/// at (d, c), d = l2 cos(M - theta), c = l2 sin(M - theta). It is on the ellipse iff (1 - d/b)^2 + (c/a)^2 = 1;
/// multiplied by sin^2 theta l1 / l2, with `ratio` = l2 / l1 <= 1 and C = cos(M - theta) / cos(theta):
///   ratio (C^2 sin^2 theta + sin^2(M - theta)) - 2 C sin^2 theta,
/// positive at theta = 0, and not at theta = M/2. `far` and `near` are the legs.
AxisDirection axis_direction(const Vec2& far, const Vec2& near) {
  const double ratio = near.norm() / far.norm(), area = std::abs(cross(far, near)), dot = far.dot(near);
  const double sine_between = area / (far.norm() * near.norm());
  const auto equation = [&](const AxisDirection& at) -> ValueAndSlope {
    const auto& [s, c, sm, cm] = at;
    const double quotient = cm / c, slope = sine_between / (c * c);
    return {ratio * (quotient * quotient * s * s + sm * sm) - 2.0 * quotient * s * s,
            ratio * (2.0 * quotient * slope * s * s + 2.0 * quotient * quotient * s * c - 2.0 * sm * cm) -
                2.0 * slope * s * s - 4.0 * quotient * s * c};
  };
  // The unknown is theta for a sharp turn and its complement eta for a gentle one, so that what is small has all its
  // digits.
  if (dot > 0.0) {
    const double between = std::atan2(area, dot);
    const auto at = [between](double theta) -> AxisDirection {
      return {std::sin(theta), std::cos(theta), std::sin(between - theta), std::cos(between - theta)};
    };
    const double guess = 0.5 * between * std::sqrt(ratio);
    return at(falling_root_in([&](double theta) { return equation(at(theta)); }, 0.0, 0.5 * between, guess));
  }
  const double turn = std::atan2(area, -dot);  // pi - M; at eta = turn the function is positive again, as C = 0
  const auto at = [turn](double eta) -> AxisDirection {
    return {std::cos(eta), std::sin(eta), std::cos(turn - eta), std::sin(turn - eta)};
  };
  const auto falling = [&](double eta) -> ValueAndSlope {
    const ValueAndSlope q = equation(at(eta));
    return {-q.value, q.slope};
  };
  return at(falling_root_in(falling, 0.5 * turn, turn, turn * (1.0 - 0.5 * ratio)));
}

}  // namespace

bool folds_back(const Vec2& p0, const Vec2& p1, const Vec2& p2, double sine) {
  return parallel(p1 - p0, p2 - p1, sine) && (p1 - p0).dot(p2 - p1) < 0.0;
}

ArcPair circle_through(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const HalfTurns turns = half_turns(p0, p1, p2);
  const ClothoidForm first = circular_arc(p0, p1, turns.first), second = circular_arc(p1, p2, turns.second);
  return {std::make_shared<ClothoidSegment>(first), std::make_shared<ClothoidSegment>(second), first.length,
          second.length};
}

ArcPair ellipse_through(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const Vec2 before = p0 - p1, after = p2 - p1;
  if (parallel(before, after, parallel_sine)) return {line(p0, p1), line(p1, p2), before.norm(), after.norm()};

  const bool after_is_far = after.squaredNorm() > before.squaredNorm();
  const Vec2& far = after_is_far ? after : before;
  const Vec2& near = after_is_far ? before : after;
  const double l1 = far.norm(), l2 = near.norm(), side = cross(far, near) > 0.0 ? 1.0 : -1.0;
  const AxisDirection theta = axis_direction(far, near);
  const double a = l1 * theta.sine, b = l1 * theta.cosine;

  const Vec2 axis = (far * theta.cosine + left_normal(far) * (side * theta.sine)) / l1;  // from p1 to the centre
  const Vec2 centre = p1 + b * axis;
  // The far point seen from the centre: side * a to the right of the axis.
  const Vec2 to_far = -side * a * left_normal(axis);
  const double near_angle = std::atan2(l2 * theta.rest_sine / a, 1.0 - l2 * theta.rest_cosine / b);
  const double w0 = after_is_far ? -near_angle : -0.5 * pi, w2 = after_is_far ? 0.5 * pi : near_angle;
  const EllipticArcForm arc{centre, -b * axis, after_is_far ? to_far : Vec2(-to_far), w0, 0.0};
  EllipticArcForm rest = arc;
  rest.from = 0.0;
  rest.to = w2;
  return {std::make_shared<EllipticArcSegment>(arc), std::make_shared<EllipticArcSegment>(rest), -w0, w2};
}

ArcPair circle_or_ellipse_through(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const HalfTurns turns = half_turns(p0, p1, p2);
  const bool gentle = std::max(std::abs(turns.first), std::abs(turns.second)) <= 0.25 * pi;
  return gentle ? circle_through(p0, p1, p2) : ellipse_through(p0, p1, p2);
}

}  // namespace kappabench
