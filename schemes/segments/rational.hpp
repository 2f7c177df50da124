#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// A rational Bézier segment of degree 1 to 5 with positive weights: conics and, by projective maps, their like.
class RationalSegment final : public Segment {
 public:
  /// 2 to 6 control points and one weight for each; throws std::invalid_argument for other numbers, and for a weight
  /// that is not positive and finite.
  explicit RationalSegment(RationalForm form);

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override { return form_; }
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  RationalForm form_;
};

}  // namespace kappabench
