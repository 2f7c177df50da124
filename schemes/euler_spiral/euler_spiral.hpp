#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// The Euler-spiral spline (Levien 2009; Bertolazzi and Frego 2018): one clothoid between points, curvature continuous,
/// a circular arc or given headings at open ends. One tridiagonal system of nonlinear equations for the headings.
class EulerSpiral final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit EulerSpiral(Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
