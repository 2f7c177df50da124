#include "schemes/segments/open_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "schemes/segments/polynomial.hpp"

namespace kappabench {

void add_end_nodes(std::vector<Node>& nodes, int points, int segments) {
  nodes.insert(nodes.begin(), {.point = 0, .segment = 0, .t = 0.0});
  nodes.push_back({.point = points - 1, .segment = segments - 1, .t = 1.0});
}

Line line_of(std::span<const Vec2> points, bool closed) {
  const Vec2& origin = points.front();
  const auto farther = [&](const Vec2& p, const Vec2& q) {
    return (p - origin).squaredNorm() < (q - origin).squaredNorm();
  };
  const Vec2 along = *std::max_element(points.begin(), points.end(), farther) - origin;
  Line line{true, !closed};
  double before = 0.0;
  for (const Vec2& p : points) {
    line.straight = line.straight && std::abs(cross(along, p - origin)) <= 1e-13 * along.squaredNorm();
    const double at = along.dot(p - origin);
    line.in_order = line.in_order && at >= before;
    before = at;
  }
  return line;
}

Curve straight_line(std::span<const Vec2> points) {
  const std::size_t n = points.size();
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  if (n == 2) segments.push_back(std::make_shared<const PolynomialSegment>(std::array{points[0], points[1]}));
  Vec2 start = points.front();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vec2& p = points[i];
    const Vec2 end = i + 2 == n ? points[n - 1] : Vec2(0.5 * (p + points[i + 1]));
    const int number = static_cast<int>(segments.size());
    nodes.push_back({.point = static_cast<int>(i), .segment = number, .t = (p - start).norm() / (end - start).norm()});
    segments.push_back(std::make_shared<const PolynomialSegment>(std::array{start, end}));
    if (i + 2 < n) joints.push_back({number, Continuity::g2});
    start = end;
  }
  add_end_nodes(nodes, static_cast<int>(n), static_cast<int>(segments.size()));
  return {std::move(segments), std::move(joints), std::move(nodes), false};
}

}  // namespace kappabench
