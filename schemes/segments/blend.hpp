#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// cos^2(pi t / 2) * from(t) + sin^2(pi t / 2) * to(t) (Yuksel 2020), for `from` and `to` that share both their ends:
/// the first two derivatives at t = 0 are those of `from`, at t = 1 those of `to`.
///
/// Ends that are shared to rounding leave gaps g = from(0) - to(0) and h = to(1) - from(1). The weights' second
/// derivatives multiply them, and next to a short leg that is no small part of the curvature: so, with the two weights
/// v and w, v w (v g + w h) is added, which takes just this away.
class BlendSegment final : public Segment {
 public:
  BlendSegment(SegmentPtr from, SegmentPtr to);

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override;
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  SegmentPtr from_;
  SegmentPtr to_;
  Vec2 start_gap_, end_gap_;
};

}  // namespace kappabench
