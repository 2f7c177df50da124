#pragma once

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// The epsilon-kappa-curve on cubic Bernstein polynomials (Miura et al. 2022, Section 3). `a` in [2/3, 1)
/// sets how sharp the curvature peaks are; `PointOptions::a` overrides it at a point. a = 2/3 is the
/// kappa-curve.
class EkappaScheme final : public Scheme {
 public:
  explicit EkappaScheme(Parameters parameters);
  [[nodiscard]] static SchemeInfo describe();

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
