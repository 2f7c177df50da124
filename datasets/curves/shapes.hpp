#pragma once

#include "datasets/curves/pen.hpp"

namespace kappabench {

/// Basic shapes of SVG (SVG 2, chapter 10), drawn from where the standard starts them, clockwise on the screen. Without
/// a size, or with a negative one, nothing is drawn.
void draw_ellipse(const Vec2& centre, const Vec2& radii, Pen& pen);
/// With corners rounded by `radii`, at most by half the size.
void draw_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii, Pen& pen);

}  // namespace kappabench
