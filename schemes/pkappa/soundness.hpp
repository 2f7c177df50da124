#pragma once

#include <optional>
#include <span>
#include <vector>

#include "schemes/pkappa/joint_chain.hpp"

namespace kappabench::pkappa {

/// What a finer rule finds in a segment. Lengths are over the segment's own unit.
struct SegmentCheck {
  /// E_p agrees with that on the rule it was minimised with (a cusp or a tight loop between nodes would show), there is
  /// no near-cusp so narrow that the finest rule's nodes may miss it, |c'| is nowhere below 5e-6, the control polygon
  /// is not much longer than the points demand, and it has not lost an edge at a joint, and with it the tangent.
  bool sound = false;
  double parabola = 0.0;              ///< E_p
  double detour = 0.0;                ///< of the spans on its two sides, control polygon over chord, the larger one
  std::optional<double> near_cusp{};  ///< where

  /// Good enough not to look for anything better.
  [[nodiscard]] bool good() const { return sound && parabola < 0.05 && detour < 1.35; }
};

/// Of segments that pass `points` at `t`, the last one followed by the first if `cyclic`.
template <int Degree>
[[nodiscard]] std::vector<SegmentCheck> check_segments(std::span<const ControlPolygon<Degree>> control,
                                                       std::span<const double> t, std::span<const Vec2> points,
                                                       std::span<const double> units, bool cyclic,
                                                       const QuadratureRule& rule);

/// The same of a chain, in the units of its segments.
template <Continuity K>
[[nodiscard]] std::vector<SegmentCheck> check_segments(const JointChain& chain, const QuadratureRule& rule);

[[nodiscard]] bool all_sound(std::span<const SegmentCheck> checks);
[[nodiscard]] bool all_good(std::span<const SegmentCheck> checks);

/// What segments are worth: whether all are sound, and their weighted energy.
struct Judgement {
  bool sound;
  double energy;
};

/// Sound where the other is not, or else below `part` of its energy.
[[nodiscard]] bool better(const Judgement& a, const Judgement& b, double part);

}  // namespace kappabench::pkappa
