#include "metrics/transformed.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace kappabench {

Vec2 Similarity::linear(Vec2 p) const {
  if (mirror) p.y() = -p.y();
  const double c = std::cos(angle), s = std::sin(angle);
  return scale * Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
}

Similarity Similarity::inverse() const {
  // A mirror is its own inverse; before it, the turn runs the other way.
  Similarity back{1.0 / scale, mirror ? angle : -angle, Vec2::Zero(), mirror};
  back.shift = -back.linear(shift);
  return back;
}

Input transformed(Input input, const Similarity& map) {
  for (Vec2& p : input.points) p = map(p);
  for (PointOptions& options : input.options) {
    if (options.tangent) options.tangent = (map.mirror ? -*options.tangent : *options.tangent) + map.angle;
    if (options.curvature) options.curvature = (map.mirror ? -*options.curvature : *options.curvature) / map.scale;
  }
  return input;
}

Input reordered(const Input& input, const std::vector<int>& order) {
  Input result;
  result.closed = input.closed;
  for (const int i : order) {
    result.points.push_back(input.points[static_cast<std::size_t>(i)]);
    result.ids.push_back(input.id_of(i));
    if (!input.options.empty()) result.options.push_back(input.options_of(i));
  }
  return result;
}

Input reversed(const Input& input, const std::vector<int>& order) {
  Input result = reordered(input, order);
  for (PointOptions& options : result.options) {
    std::swap(options.alpha, options.beta);
    if (options.tangent) options.tangent = *options.tangent + std::numbers::pi;
    if (options.curvature) options.curvature = -*options.curvature;
  }
  return result;
}

std::vector<Span> with_old_names(std::vector<Span> renamed, const std::vector<int>& order) {
  for (Span& span : renamed) {
    if (span.from != no_point) span.from = order[static_cast<std::size_t>(span.from)];
    if (span.to != no_point) span.to = order[static_cast<std::size_t>(span.to)];
  }
  return renamed;
}

Input perturbed(Input input, double step, double start) {
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const double direction = start + golden_angle * static_cast<double>(i);
    input.points[i] += step * Vec2(std::cos(direction), std::sin(direction));
  }
  return input;
}

}  // namespace kappabench
