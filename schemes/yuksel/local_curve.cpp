#include "schemes/yuksel/local_curve.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "schemes/numerics/bracketed_newton.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/reparametrized.hpp"

namespace kappabench::yuksel {

Arc arc_of(std::string_view word) {
  if (word == "bezier") return Arc::bezier;
  if (word == "circular") return Arc::circular;
  if (word == "elliptical") return Arc::elliptical;
  if (word == "hybrid") return Arc::hybrid;
  throw std::logic_error("yuksel: unknown arc");
}

namespace {

/// The parameter t where a quadratic Bezier curve with ends p1 + v0, p1 + v2 passes p1 and has its curvature peak: the
/// one root in (0, 1) of -|v0|^2 u^3 - (v0.v2) t u^2 + (v0.v2) t^2 u + |v2|^2 t^3, u = 1 - t (as for kappa-curves, Yan
/// et al. 2017).
double peak_parameter(const Vec2& v0, const Vec2& v2) {
  const double aa = v0.squaredNorm(), ab = v0.dot(v2), bb = v2.squaredNorm();
  const auto negative = [&](double t) -> ValueAndSlope {
    const double u = 1.0 - t;
    return {aa * u * u * u + ab * t * u * (u - t) - bb * t * t * t,
            -3.0 * aa * u * u + ab * (u * u - 4.0 * t * u + t * t) - 3.0 * bb * t * t};
  };
  const double a = std::cbrt(aa), b = std::cbrt(bb);
  return falling_root_in(negative, 0.0, 1.0, a / (a + b));  // exact for perpendicular legs
}

/// The quadratic curve split at p1. The inner control points of the halves are p1 plus a combination of the legs, from
/// b1 - p1 = -(u^2 v0 + t^2 v2) / (2 t u).
ArcPair bezier_through(const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  const Vec2 v0 = p0 - p1, v2 = p2 - p1;
  const double t = peak_parameter(v0, v2), u = 1.0 - t;
  const Vec2 inner0 = p1 + 0.5 * u * v0 - t * t / (2.0 * u) * v2;
  const Vec2 inner2 = p1 + 0.5 * t * v2 - u * u / (2.0 * t) * v0;
  return {std::make_shared<PolynomialSegment>(std::array<Vec2, 3>{p0, inner0, p1}),
          std::make_shared<PolynomialSegment>(std::array<Vec2, 3>{p1, inner2, p2}), t, u};
}

}  // namespace

std::optional<ArcPair> local_curve(Arc arc, const Vec2& p0, const Vec2& p1, const Vec2& p2) {
  if (arc == Arc::bezier) return bezier_through(p0, p1, p2);
  // A circle of a million legs' size still passes the points to 1e-10 legs.
  constexpr double sharpest_circle = 1e-6;
  if (arc == Arc::circular ? folds_back(p0, p1, p2, sharpest_circle) : folds_back(p0, p1, p2)) return std::nullopt;
  if (arc == Arc::circular) return circle_through(p0, p1, p2);
  if (arc == Arc::elliptical) return ellipse_through(p0, p1, p2);
  return circle_or_ellipse_through(p0, p1, p2);
}

ArcPair with_equal_extents(const ArcPair& pair) {
  // x -> x / (1 - q x) over [-1, 1] with extents s and r: slope 2 r s / (r + s) at 0, q = (r - s) / (r + s).
  const double s = pair.first_extent, r = pair.second_extent;
  return {std::make_shared<ReparametrizedSegment>(pair.first, (r + s) / (2.0 * r)),
          std::make_shared<ReparametrizedSegment>(pair.second, 2.0 * s / (r + s)), 1.0, 1.0};
}

}  // namespace kappabench::yuksel
