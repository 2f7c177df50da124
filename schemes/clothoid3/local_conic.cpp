#include "schemes/clothoid3/local_conic.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/three_point_arcs.hpp"

namespace kappabench::clothoid3 {

namespace {

using std::numbers::pi;

G2Data by_derivatives(const ArcPair& pair, Place place) {
  const Jet jet =
      place == Place::start ? pair.first->jet(0.0, 2) : pair.second->jet(place == Place::end ? 1.0 : 0.0, 2);
  return {tangent_angle(jet), curvature(jet)};
}

/// The ellipse after 16 bisections, without the last step: its near point misses p0 or p2 by up to 1e-5 of the angle.
/// The centre moves on the circle over the far leg as diameter.
ArcPair bisected_ellipse(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const bool reverse = (p2 - p1).norm() > (p0 - p1).norm();
  const Vec2& far = reverse ? p2 : p0;
  const Vec2& near = reverse ? p0 : p2;
  const double side = cross(far - p1, near - p1) > 0.0 ? 1.0 : -1.0, dot = (far - p1).dot(near - p1);
  const Vec2 middle = 0.5 * (far + p1), radius = far - middle;
  double angle = 0.5 * side * pi, step = 0.25 * side * pi;
  EllipticArcForm form{};
  double near_angle = 0.0;
  for (int k = 0; k < 16; ++k) {
    form.centre = middle + std::cos(angle) * radius + std::sin(angle) * left_normal(radius);
    form.axis_a = far - form.centre;
    form.axis_b = p1 - form.centre;
    const double c = (near - form.centre).dot(form.axis_a) / form.axis_a.squaredNorm();
    const double s = (near - form.centre).dot(form.axis_b) / form.axis_b.squaredNorm();
    near_angle = std::atan2(s, c);
    if (near_angle < 0.0) near_angle += 2.0 * pi;
    const bool outside = c * c + s * s > 1.0;
    angle += outside && (dot > 0.0 ? c < 0.0 : s > 0.0) ? step : -step;
    step *= 0.5;
  }
  const auto arc = [&](double from, double to) {
    EllipticArcForm half = form;
    half.from = from;
    half.to = to;
    return std::make_shared<EllipticArcSegment>(half);
  };
  if (reverse) return {arc(near_angle, 0.5 * pi), arc(0.5 * pi, 0.0), near_angle - 0.5 * pi, 0.5 * pi};
  return {arc(0.0, 0.5 * pi), arc(0.5 * pi, near_angle), 0.5 * pi, near_angle - 0.5 * pi};
}

ArcPair published_conic(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const Vec2 before = p1 - p0, after = p2 - p1;
  if (std::abs(cross(before, after)) < 1e-6 * before.norm() * after.norm()) {
    const auto line = [](const Vec2& a, const Vec2& b) {
      return std::make_shared<PolynomialSegment>(std::array<Vec2, 2>{a, b});
    };
    return {line(p0, p1), line(p1, p2), before.norm(), after.norm()};
  }
  const ArcPair circle = circle_through(p0, p1, p2);
  const double turn = std::abs(curvature(circle.first->jet(0.0, 2)));
  const bool gentle = turn * circle.first_extent < 0.5 * pi && turn * circle.second_extent < 0.5 * pi;
  return gentle ? circle : bisected_ellipse(p0, p1, p2);
}

/// The pair as one curve over [0, 2].
Vec2 at(const ArcPair& pair, double t) {
  return (t < 1.0 ? pair.first->jet(t, 0) : pair.second->jet(t - 1.0, 0)).position();
}

/// Forward difference for the heading, at the place; for the curvature a forward and a central one, two steps inside.
G2Data by_differences(const ArcPair& pair, Place place) {
  constexpr double h = 1e-3;
  const double t = place == Place::start ? h : place == Place::end ? 2.0 - h : 1.0;
  const Vec2 tangent = at(pair, t + h) - at(pair, t);
  const double u = place == Place::start ? 2.0 * h : place == Place::end ? 2.0 - 2.0 * h : 1.0 + 2.0 * h;
  const Vec2 first = (at(pair, u + h) - at(pair, u)) / h;
  const Vec2 second = (at(pair, u + h) - 2.0 * at(pair, u) + at(pair, u - h)) / (h * h);
  const double speed = first.norm();
  return {std::atan2(tangent.y(), tangent.x()), speed < 1e-6 ? 0.0 : cross(first, second) / (speed * speed * speed)};
}

}  // namespace

G2Data local_conic(const Vec2& p0, const Vec2& p1, const Vec2& p2, Place place, const Rules& rules) {
  if (rules.compat) return by_differences(published_conic(p0, p1, p2), place);
  return by_derivatives(circle_or_ellipse_through(p0, p1, p2), place);
}

}  // namespace kappabench::clothoid3
