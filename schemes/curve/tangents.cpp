#include "schemes/curve/tangents.hpp"

#include <cmath>

namespace kappabench {

Vec2 unit_tangent(const Segment& segment, double t, Side side, double rest) {
  const Jet jet = segment.jet(t, max_jet_order);
  double sign = 1.0;
  for (std::size_t k = 1; k <= max_jet_order; ++k) {
    const double size = jet.d[k].norm();
    if (size > rest && std::isfinite(size)) return sign * jet.d[k] / size;
    if (side == Side::before) sign = -sign;  // c'(t - h) = c' - h c'' + ...
  }
  return Vec2::Zero();
}

double angle_between(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

}  // namespace kappabench
