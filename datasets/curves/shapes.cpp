#include "datasets/curves/shapes.hpp"

namespace kappabench {

namespace {

void quarter_to(const Vec2& radii, const Vec2& to, Pen& pen) {
  pen.arc_to({.radii = radii, .rotation = 0.0, .large = false, .sweep = true}, to);
}

}  // namespace

void draw_ellipse(const Vec2& centre, const Vec2& radii, Pen& pen) {
  if (!(radii.minCoeff() > 0.0)) return;
  const Vec2 x(radii.x(), 0.0), y(0.0, radii.y());
  pen.move_to(centre + x);
  quarter_to(radii, centre + y, pen);
  quarter_to(radii, centre - x, pen);
  quarter_to(radii, centre - y, pen);
  quarter_to(radii, centre + x, pen);
  pen.close();
}

void draw_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii, Pen& pen) {
  if (!(size.minCoeff() > 0.0)) return;
  const Vec2 r = radii.cwiseMax(0.0).cwiseMin(0.5 * size);
  const Vec2 x(r.x(), 0.0), y(0.0, r.y());
  const Vec2 top_left = corner, bottom_right = corner + size;
  const Vec2 top_right(bottom_right.x(), corner.y()), bottom_left(corner.x(), bottom_right.y());
  // Arcs without a radius have no length, for their ends are one point then.
  pen.move_to(top_left + x);
  pen.line_to(top_right - x);
  quarter_to(r, top_right + y, pen);
  pen.line_to(bottom_right - y);
  quarter_to(r, bottom_right - x, pen);
  pen.line_to(bottom_left + x);
  quarter_to(r, bottom_left - y, pen);
  pen.line_to(top_left + y);
  quarter_to(r, top_left + x, pen);
  pen.close();
}

}  // namespace kappabench
