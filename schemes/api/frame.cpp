#include "schemes/api/frame.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace kappabench {

namespace {

constexpr double far = 16.0;         // extents
constexpr int common_exponent = 30;  // of the extent

void place_curvature(PointOptions& options, const Placement& placement) {
  if (options.curvature) *options.curvature /= placement.scale;
}

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
  placed.known_to = rounding_of(input) * placement.scale;
  for (Vec2& p : placed.points) p = placement(p);
  for (PointOptions& options : placed.options) place_curvature(options, placement);
  return placed;
}

Edit place(const Edit& edit, const Placement& placement) {
  if (const auto* move = std::get_if<Move>(&edit)) return Move{move->point, placement(move->to)};
  if (const auto* insert = std::get_if<Insert>(&edit)) {
    Insert placed = *insert;
    placed.at = placement(placed.at);
    place_curvature(placed.options, placement);
    return placed;
  }
  return edit;
}

Fit place(const Fit& fit, const Placement& placement) {
  Fit placed{place(fit.input, placement), std::nullopt, fit.report};
  if (fit.curve) placed.curve = place(*fit.curve, placement);
  return placed;
}

}  // namespace kappabench
