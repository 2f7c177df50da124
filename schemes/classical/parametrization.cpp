#include "schemes/classical/parametrization.hpp"

#include <cmath>
#include <utility>

#include "schemes/segments/spans.hpp"

namespace kappabench {

std::vector<double> span_lengths(const Input& input, double alpha) {
  std::vector<double> lengths(input.points.size() - (input.closed ? 0 : 1));
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Vec2& next = input.points[(i + 1) % input.points.size()];
    lengths[i] = std::pow((next - input.points[i]).norm(), alpha);
  }
  return lengths;
}

Curve curve_through_joints(std::vector<SegmentPtr> segments, bool closed, Continuity smooth) {
  std::vector<SpanPieces> spans;
  spans.reserve(segments.size());
  for (SegmentPtr& segment : segments)
    spans.push_back({.segments = {std::move(segment)}, .inside = smooth, .at_end = smooth});
  return curve_of_spans(std::move(spans), closed);
}

}  // namespace kappabench
