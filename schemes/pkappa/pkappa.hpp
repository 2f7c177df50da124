#pragma once

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// Wang et al. 2024: Bézier segments whose curvature approximates a parabola. See README.md.
class PkappaScheme final : public Scheme {
 public:
  static SchemeInfo describe();
  explicit PkappaScheme(const Parameters& parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
  [[nodiscard]] Fit resolve(const Fit& fit, const Edit& edit) const override;
};

}  // namespace kappabench
