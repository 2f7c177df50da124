#include "experiments/papers/fpc-2019-chen/common.hpp"

#include <algorithm>
#include <iterator>

#include "datasets/datasets.hpp"
#include "experiments/study/measured.hpp"
#include "experiments/study/selection.hpp"
#include "metrics/features.hpp"

namespace kappabench::chen {

std::vector<Drawing> gallery_or(const Context& context) {
  return study::drawings_or(
      context, {"butterfly", "clover", "leaf-with-tips", "ribbon", "bat", "flourish", "fish-in-one-line", "clef"});
}

std::vector<Node> nodes_of(const Curve& curve, int point) {
  std::vector<Node> found;
  std::ranges::copy_if(curve.nodes(), std::back_inserter(found),
                       [point](const Node& node) { return node.point == point; });
  return found;
}

CellJob loops_job(const Context& context, const LoopCase& which) {
  return fit_job(open_drawings(which.drawing).front(), context.registry.create(which.scheme),
                 {&find_metric("features")});
}

Loops loops_of(const study::Findings& found, const LoopCase& which) {
  const auto cell = found.find(which.drawing, which.scheme);
  const store::CurveRecord* curve = cell ? found.curve(*cell) : nullptr;
  if (curve == nullptr) return {};
  return {*cell, static_cast<double>(curve->point_x.size()), measured(*curve, column::loops).value_or(0.0),
          measured(*curve, column::loops_at_nodes).value_or(0.0)};
}

}  // namespace kappabench::chen
