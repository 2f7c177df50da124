#pragma once

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// The epsilon-kappa-curve on the quadratic trigonometric basis (Miura et al. 2022, Section 4). `a` in
/// [1/2, 1) sets how sharp the curve is at the points; `PointOptions::a` overrides it at a point.
/// The points sit where curvature is stationary, which for small `a` and gentle turns is often a
/// *minimum* of |kappa|: the mark curvature_minimum says where.
class EkappaTrigScheme final : public Scheme {
 public:
  explicit EkappaTrigScheme(Parameters parameters);
  [[nodiscard]] static SchemeInfo describe();

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
