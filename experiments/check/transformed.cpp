#include "experiments/check/transformed.hpp"

#include <memory>
#include <utility>

namespace kappabench::check {

namespace {

/// Another segment under a map.
class TransformedSegment final : public Segment {
 public:
  TransformedSegment(SegmentPtr of, Similarity map) : of_(std::move(of)), map_(std::move(map)) {}

  [[nodiscard]] Jet jet(double t, int order) const override {
    Jet result = of_->jet(t, order);
    result.d[0] = map_(result.d[0]);
    for (int k = 1; k <= order; ++k) {
      Vec2& d = result.d[static_cast<std::size_t>(k)];
      d = map_.linear(d);
    }
    return result;
  }
  [[nodiscard]] ExactForm exact() const override { return OpaqueForm{}; }

 private:
  SegmentPtr of_;
  Similarity map_;
};

}  // namespace

Curve transformed(const Curve& curve, const Similarity& map) {
  std::vector<SegmentPtr> segments;
  for (const SegmentPtr& segment : curve.segments())
    segments.push_back(std::make_shared<TransformedSegment>(segment, map));
  return {std::move(segments), curve.joints(), curve.nodes(), curve.closed()};
}

}  // namespace kappabench::check
