#pragma once

#include "schemes/api/scheme.hpp"

namespace kappabench {

/// FPC-curves (Chen 2019): a cubic Bézier segment for each point, in which the point is a cusp, a loop, an inflection
/// or a regular point as its option `type` says (regular if it says nothing); G2 where the curvature keeps its sign.
/// The end points of an open curve are its ends and have no type. Closed from 3 points: with 2 everything lies on one
/// line. Open from 3: with one inner point there is one segment and nothing to solve for.
/// Residual, counters and outcomes are defined in this folder's README.
class FpcScheme final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit FpcScheme(Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
