#pragma once

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// cos^2(pi t / 2) * from(t) + sin^2(pi t / 2) * to(t) (Yuksel 2020). Where `from` and `to` start at one point, the
/// first two derivatives at t = 0 are those of `from`; likewise those of `to` at t = 1.
class BlendSegment final : public Segment {
 public:
  BlendSegment(SegmentPtr from, SegmentPtr to);

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override;
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  SegmentPtr from_;
  SegmentPtr to_;
};

}  // namespace kappabench
