#pragma once

#include "schemes/api/registry.hpp"

namespace kappabench {

/// The cubic Catmull-Rom spline with span lengths |chord|^alpha (Barry and Goldman 1988): C1 in the global parameter,
/// hence G1 between segments. No system to solve; a point moves two spans on each side.
/// At open ends the missing neighbour is the end point reflected: p_{-1} = 2 p_0 - p_1.
class CatmullRom final : public Scheme {
 public:
  [[nodiscard]] static SchemeInfo describe();
  explicit CatmullRom(Parameters parameters);

 private:
  [[nodiscard]] Fit solve(const Input& input) const override;
};

}  // namespace kappabench
