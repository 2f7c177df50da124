#pragma once

#include "schemes/api/registry.hpp"
#include "schemes/intrinsic/hermite_chain.hpp"

namespace kappabench {

/// Curves whose curvature is an explicit B-spline over arc length (Yoshida and Saito 2022), one segment between two
/// points: heading and curvature at the points are given or estimated, and every span is a Hermite problem of its own.
class Intrinsic final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  /// Throws std::invalid_argument if `knots` is not a clamped knot vector of the degree, or `controls` <= `degree`.
  explicit Intrinsic(const Parameters& parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;

  intrinsic::Settings settings_;
  intrinsic::Estimates estimates_;
  bool g2_;
};

}  // namespace kappabench
