#include "schemes/classical/parametrization.hpp"

#include <cmath>

namespace kappabench {

namespace {

std::size_t span_count(const Input& input) { return input.points.size() - (input.closed ? 0 : 1); }

}  // namespace

std::vector<double> span_lengths(const Input& input, double alpha) {
  std::vector<double> lengths(span_count(input));
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Vec2& next = input.points[(i + 1) % input.points.size()];
    lengths[i] = std::pow((next - input.points[i]).norm(), alpha);
  }
  return lengths;
}

std::vector<Node> nodes_at_joints(const Input& input) {
  const int spans = static_cast<int>(span_count(input));
  std::vector<Node> nodes;
  for (int i = 0; i < input.size(); ++i)
    nodes.push_back(i < spans ? Node{.point = i, .segment = i, .t = 0.0}
                              : Node{.point = i, .segment = i - 1, .t = 1.0});
  return nodes;
}

std::vector<Joint> joints_at_points(const Input& input, Continuity claimed) {
  const int joints = static_cast<int>(span_count(input)) - (input.closed ? 0 : 1);
  std::vector<Joint> result;
  for (int i = 0; i < joints; ++i) result.push_back({.segment = i, .claimed = claimed});
  return result;
}

}  // namespace kappabench
