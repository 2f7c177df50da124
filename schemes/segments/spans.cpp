#include "schemes/segments/spans.hpp"

#include <utility>

#include "schemes/segments/joint_claim.hpp"

namespace kappabench {

Curve curve_of_spans(std::vector<SpanPieces> spans, bool closed) {
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  std::vector<std::size_t> ends;  // the last joint of each span
  int point = 0;
  for (SpanPieces& span : spans) {
    nodes.push_back({.point = point++, .segment = static_cast<int>(segments.size()), .t = 0.0});
    for (SegmentPtr& segment : span.segments) {
      segments.push_back(std::move(segment));
      joints.push_back({.segment = static_cast<int>(segments.size()) - 1, .claimed = span.inside});
    }
    joints.back().claimed = span.at_end;
    ends.push_back(joints.size() - 1);
  }
  if (!closed) {
    joints.pop_back();
    ends.pop_back();
    nodes.push_back({.point = point, .segment = static_cast<int>(segments.size()) - 1, .t = 1.0});
  }
  for (const std::size_t end : ends)
    joints[end].claimed =
        claim_at(*segments[end], *segments[end + 1 < segments.size() ? end + 1 : 0], joints[end].claimed);
  return {std::move(segments), std::move(joints), std::move(nodes), closed};
}

}  // namespace kappabench
