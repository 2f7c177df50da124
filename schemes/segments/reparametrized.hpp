#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// Another segment with its parameter sent through x = m t / (1 + (m - 1) t), m = `start_speed` > 0: the one fractional
/// linear map of [0, 1] onto itself whose slope is m at 0, and then 1 / m at 1. The shape stays, the speeds at the ends
/// change.
class ReparametrizedSegment final : public Segment {
 public:
  ReparametrizedSegment(SegmentPtr of, double start_speed);

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override;
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  SegmentPtr of_;
  double start_speed_;
};

}  // namespace kappabench
