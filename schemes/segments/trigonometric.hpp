#pragma once

#include <array>

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// A quadratic trigonometric segment (Miura 2022, Eqs. (14) to (17)): five control points over
/// {u^2, 2uv, 4uw, 2vw, w^2}.
class TrigonometricSegment final : public Segment {
 public:
  explicit TrigonometricSegment(const std::array<Vec2, 5>& control_points);

  [[nodiscard]] const std::array<Vec2, 5>& control_points() const { return control_points_; }

  [[nodiscard]] Jet jet(double t, int order) const override;
  [[nodiscard]] ExactForm exact() const override;
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  std::array<Vec2, 5> control_points_;
};

}  // namespace kappabench
