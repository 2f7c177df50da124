#include "schemes/curve/segment.hpp"

#include <cassert>
#include <utility>

namespace kappabench {

void Segment::jets(std::span<const double> t, int order, std::span<Jet> out) const {
  assert(t.size() == out.size());
  for (std::size_t i = 0; i < t.size(); ++i) out[i] = jet(t[i], order);
}

namespace {

class PlacedSegment final : public Segment {
 public:
  PlacedSegment(SegmentPtr of, Placement placement) : of_(std::move(of)), placement_(std::move(placement)) {}

  [[nodiscard]] Jet jet(double t, int order) const override {
    Jet jet = of_->jet(t, order);
    jet.d[0] = placement_(jet.d[0]);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(order); ++k) jet.d[k] *= placement_.scale;
    return jet;
  }
  [[nodiscard]] ExactForm exact() const override { return OpaqueForm{}; }

 private:
  SegmentPtr of_;
  Placement placement_;
};

}  // namespace

SegmentPtr place(const SegmentPtr& segment, const Placement& placement) {
  if (SegmentPtr placed = segment->placed(placement)) return placed;
  return std::make_shared<PlacedSegment>(segment, placement);
}

}  // namespace kappabench
