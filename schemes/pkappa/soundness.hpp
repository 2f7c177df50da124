#pragma once

#include <optional>
#include <span>

#include "schemes/pkappa/joint_chain.hpp"

namespace kappabench::pkappa {

/// What a finer rule finds in a result.
struct Verification {
  /// E_p of every segment agrees with that on the rule it was minimised with (a cusp or a tight loop between nodes
  /// would show), none has a near-cusp so narrow that the finest rule's nodes may miss it, no control polygon is much
  /// longer than the points demand, and none has lost an edge at a joint, and with it the tangent.
  bool sound = false;
  double worst_parabola = 0.0;        ///< the largest E_p of a segment
  int unsound_segment = -1;           ///< the first that is not sound
  std::optional<double> near_cusp{};  ///< where its near-cusp is, if that is why

  /// Good enough, in units of the mean chord, not to look for anything better.
  [[nodiscard]] bool good() const { return sound && worst_parabola < 0.05; }
};

/// Of segments that pass `points` at `t`; lengths are taken over `unit`.
template <int Degree>
[[nodiscard]] Verification verify(std::span<const ControlPolygon<Degree>> control, std::span<const double> t,
                                  std::span<const Vec2> points, double unit, const QuadratureRule& rule);

/// Of a chain, which has the unit 1.
template <Continuity K>
[[nodiscard]] Verification verify(const JointChain& chain, const QuadratureRule& rule);

}  // namespace kappabench::pkappa
