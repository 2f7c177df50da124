#include "schemes/kappa/marks.hpp"

#include <string>

namespace kappabench::kappa::marks {

std::vector<MarkSpec> of(SegmentKind kind) {
  std::vector<MarkSpec> specs{
      {std::string(pinned),
       "the point is an end of its segment, so that |curvature| need not peak on both sides of it"},
      {std::string(at_inflection),
       "the point's own segment has shrunk to nothing at an inflection; the node is the joint of its neighbours"}};
  if (kind == SegmentKind::trigonometric)
    specs.push_back(
        {std::string(curvature_minimum), "|curvature| is stationary at the point, but has a minimum there"});
  return specs;
}

}  // namespace kappabench::kappa::marks
