#include "schemes/segments/spans.hpp"

#include <utility>

namespace kappabench {

Curve curve_of_spans(std::vector<SpanPieces> spans, bool closed) {
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  int point = 0;
  for (SpanPieces& span : spans) {
    nodes.push_back({.point = point++, .segment = static_cast<int>(segments.size()), .t = 0.0});
    for (SegmentPtr& segment : span.segments) {
      segments.push_back(std::move(segment));
      joints.push_back({.segment = static_cast<int>(segments.size()) - 1, .claimed = span.inside});
    }
    joints.back().claimed = span.at_end;
  }
  if (!closed) {
    joints.pop_back();
    nodes.push_back({.point = point, .segment = static_cast<int>(segments.size()) - 1, .t = 1.0});
  }
  return {std::move(segments), std::move(joints), std::move(nodes), closed};
}

}  // namespace kappabench
