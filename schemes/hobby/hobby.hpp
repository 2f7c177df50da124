#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// The curves of METAFONT and METAPOST (Hobby 1986): cubic pieces with tangents that make a linear stand-in for
/// curvature, the mock curvature, continuous. One tridiagonal system; G1.
class Hobby final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit Hobby(Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
