#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// Levien's Euler-spiral spline (2009): one clothoid between points, curvature continuous, a circular arc at open ends.
/// Solved by libspiro; the clothoids are taken from its solution, not from the Bezier curves that it also makes.
class Spiro final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit Spiro(Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
