#pragma once

#include <array>
#include <span>

#include "schemes/curve/segment.hpp"

namespace kappabench {

/// A Bézier segment of degree 1 to 5. Control points are stored in place: a curve of a million segments
/// is a million small blocks, not two.
class PolynomialSegment final : public Segment {
 public:
  static constexpr int max_degree = 5;

  /// 2 to 6 Bernstein control points; throws std::invalid_argument for any other number.
  explicit PolynomialSegment(std::span<const Vec2> control_points);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] std::span<const Vec2> control_points() const {
    return std::span{control_points_}.first(static_cast<std::size_t>(degree_) + 1);
  }

  [[nodiscard]] Jet jet(double t, int order) const override;
  void jets(std::span<const double> t, int order, std::span<Jet> out) const override;
  [[nodiscard]] ExactForm exact() const override;
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;
  [[nodiscard]] std::span<const Vec2> bezier_points() const override { return control_points(); }

 private:
  std::array<Vec2, max_degree + 1> control_points_;
  int degree_;
};

}  // namespace kappabench
