#pragma once

#include <span>
#include <vector>

#include "schemes/curve/segment.hpp"
#include "schemes/numerics/bspline.hpp"

namespace kappabench {

/// Curvature an explicit B-spline over arc length, s = length * t (Yoshida 2022, Eq. (6)).
///
/// The angle is exact: its Bernstein coefficients on a knot span are running sums of those of the curvature, so that a
/// whole span turns by the mean of its coefficients (Eqs. (5), (7)). The position is the integral of
/// (cos angle, sin angle) by Gauss-Legendre quadrature on parts of spans that turn little enough for the rule to be
/// exact to rounding: error below 1e-14 of the length while the curve turns by less than about 10 rad, and beyond that
/// what the rounding of its angle makes.
class IntrinsicSegment final : public Segment {
 public:
  /// Throws std::invalid_argument if the length is not positive, a number is not finite, the knots do not form a basis
  /// (`reason_ill_formed`), or there is not one control curvature for each basis function.
  explicit IntrinsicSegment(IntrinsicForm form);

  [[nodiscard]] const IntrinsicForm& form() const { return form_; }

  [[nodiscard]] Jet jet(double t, int order) const override;
  /// Ascending parameters share their integrals.
  void jets(std::span<const double> t, int order, std::span<Jet> out) const override;
  [[nodiscard]] ExactForm exact() const override { return form_; }
  [[nodiscard]] SegmentPtr placed(const Placement& placement) const override;

 private:
  /// A knot span: Bernstein coefficients over local v in [0, 1], t = from + width v.
  struct Piece {
    double from, width;
    std::vector<double> curvature;
    std::vector<double> angle;
    Vec2 start;
  };

  [[nodiscard]] const Piece& piece_at(double t) const;
  /// From the point at v0 to the one at v1, which may be outside [0, 1].
  [[nodiscard]] Vec2 displacement(const Piece& piece, double v0, double v1) const;
  [[nodiscard]] Jet jet_at(const Piece& piece, double v, const Vec2& position, int order) const;

  IntrinsicForm form_;
  std::vector<Piece> pieces_;
};

}  // namespace kappabench
