#include "schemes/api/frame.hpp"

#include <algorithm>
#include <cmath>

namespace kappabench {

namespace {

constexpr double far = 16.0;         // extents
constexpr int common_exponent = 30;  // of the extent

}  // namespace

Placement frame_of(const Input& input) {
  if (input.points.empty()) return {};
  Vec2 low = input.points.front(), high = low;
  for (const Vec2& p : input.points) {
    if (!p.allFinite()) return {};
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  if (!(extent > 0.0) || !std::isfinite(extent)) return {};
  Placement frame;
  for (int axis = 0; axis < 2; ++axis) {
    const double middle = low[axis] + 0.5 * (high[axis] - low[axis]);
    if (std::abs(middle) > far * extent) frame.shift[axis] = middle;
  }
  const int exponent = std::clamp(std::ilogb(extent), -1000, 1000);
  if (std::abs(exponent) > common_exponent) frame.scale = std::ldexp(1.0, exponent);
  return frame;
}

Input place(const Input& input, const Placement& placement) {
  Input placed = input;
  for (Vec2& p : placed.points) p = placement(p);
  for (PointOptions& options : placed.options)
    if (options.curvature) *options.curvature /= placement.scale;
  return placed;
}

}  // namespace kappabench
