#pragma once

#include <utility>

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// An arc of an ellipse: centre + axis_a cos w + axis_b sin w with the angle w linear in t (any two conjugate half
/// axes; one may vanish).
class EllipticArcSegment final : public Segment {
 public:
  explicit EllipticArcSegment(EllipticArcForm form) : form_(std::move(form)) {}

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override { return form_; }
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  EllipticArcForm form_;
};

}  // namespace kappabench
