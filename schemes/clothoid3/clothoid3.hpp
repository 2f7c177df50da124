#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// The local clothoid spline of Binninger and Sorkine-Hornung 2022: heading and curvature at each point from its
/// neighbours, and between two points three clothoids (Bertolazzi and Frego 2018) or clothoid, line, clothoid.
/// Every step is local and done once, so time is linear in the number of points.
class Clothoid3 final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit Clothoid3(const Parameters& parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
