#include "schemes/segments/elliptic_arc.hpp"

#include <cmath>

namespace kappabench {

Jet EllipticArcSegment::jet(double t, int order) const {
  const double rate = form_.to - form_.from, w = form_.from + rate * t;
  const double cosine = std::cos(w), sine = std::sin(w);
  const Vec2 radius = form_.axis_a * cosine + form_.axis_b * sine;
  const Vec2 turned = form_.axis_b * cosine - form_.axis_a * sine;
  Jet jet;
  jet.d[0] = form_.centre + radius;
  double factor = 1.0;
  for (std::size_t r = 1; r <= static_cast<std::size_t>(order); ++r) {
    factor *= r % 2 == 0 ? -rate : rate;  // d radius / dw = turned, d turned / dw = -radius
    jet.d[r] = factor * (r % 2 == 0 ? radius : turned);
  }
  return jet;
}

SegmentPtr EllipticArcSegment::placed(const Placement& placement) const {
  EllipticArcForm form = form_;
  form.centre = placement(form.centre);
  form.axis_a *= placement.scale;
  form.axis_b *= placement.scale;
  return std::make_shared<EllipticArcSegment>(std::move(form));
}

}  // namespace kappabench
