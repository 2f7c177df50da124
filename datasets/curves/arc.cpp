#include "datasets/curves/arc.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench {

namespace {

/// Turns to the ellipse's axes: where the ellipse is a circle of radius 1, half the way from the arc's end back to its
/// start is `half`, and from the middle of that way to the centre it is `centre`.
struct UnitCircle {
  Vec2 half, centre;
};

/// SVG 2, B.2.4, equations (B.2.2.2), divided by the radii.
UnitCircle unit_circle(const Vec2& half, const ArcArguments& arc) {
  const double squared = half.squaredNorm(), rest = 1.0 - squared;
  // Of a half circle the rest is rounding, and its root would be far more.
  constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
  const double distance = rest > rounding ? std::sqrt(rest / squared) : 0.0;
  const double sign = arc.large == arc.sweep ? -1.0 : 1.0;
  return {half, sign * distance * Vec2(half.y(), -half.x())};
}

/// By which angle the arc goes on from `from`: the angles are those of its ends.
double swept(double from, double to, bool sweep) {
  const double turn = 2.0 * std::numbers::pi;
  if (sweep && to < from) return to - from + turn;
  if (!sweep && to > from) return to - from - turn;
  return to - from;
}

}  // namespace

SegmentPtr arc_between(const Vec2& from, const ArcArguments& arc, const Vec2& to, const AffineMap& map) {
  const auto line = [&] { return std::make_shared<PolynomialSegment>(std::array<Vec2, 2>{map * from, map * to}); };
  Vec2 radii = arc.radii.cwiseAbs();
  if (radii.minCoeff() == 0.0) return line();
  const double angle = arc.rotation * std::numbers::pi / 180.0;
  const Vec2 x(std::cos(angle), std::sin(angle)), y = left_normal(x);
  const Vec2 back = 0.5 * (from - to);
  Vec2 half(back.dot(x) / radii.x(), back.dot(y) / radii.y());
  // Radii that are too small grow until the ellipse reaches both points: (B.2.5.3).
  if (const double reach = half.norm(); reach > 1.0) {
    radii *= reach;
    half /= reach;
  }
  // A short arc of this chord over the diameter leaves it by a quarter of that much: its centre is too far off to say
  // where its ends are.
  constexpr double flat = 4e-8;
  if (!arc.large && half.norm() < flat) return line();

  const auto [start, centre] = unit_circle(half, arc);
  const Vec2 first = start - centre, last = -start - centre;
  const double begin = std::atan2(first.y(), first.x());
  const Vec2 axis_a = radii.x() * x, axis_b = radii.y() * y;
  const Vec2 middle = 0.5 * (from + to) + centre.x() * axis_a + centre.y() * axis_b;
  return std::make_shared<EllipticArcSegment>(
      EllipticArcForm{.centre = map * middle,
                      .axis_a = map.linear() * axis_a,
                      .axis_b = map.linear() * axis_b,
                      .from = begin,
                      .to = begin + swept(begin, std::atan2(last.y(), last.x()), arc.sweep)});
}

}  // namespace kappabench
