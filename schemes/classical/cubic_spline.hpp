#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// The C2 cubic spline through the points: natural ends if open, periodic if closed. C2 in the global parameter
/// (option `parameter`), hence G2 between segments whose own parameter runs over [0, 1].
/// One linear solve, O(n). The residual is that of the linear system, relative to its right-hand side.
class CubicSpline final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit CubicSpline(Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
