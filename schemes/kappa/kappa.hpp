#pragma once

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// The kappa-curve (Yan et al. 2017): quadratic Bézier segments, one for each interpolated point, whose
/// curvature peaks there. It is the epsilon-kappa-curve with a = 2/3; `PointOptions::a` is not read.
/// An open curve through N points has N - 2 segments: the first and the last point are only its ends.
class KappaScheme final : public Scheme {
 public:
  explicit KappaScheme(Parameters parameters);
  [[nodiscard]] static SchemeInfo describe();

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
