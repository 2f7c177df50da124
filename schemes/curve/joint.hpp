#pragma once

#include <optional>

#include "schemes/curve/curve.hpp"
#include "schemes/curve/rounding.hpp"

namespace kappabench {

/// One side of a joint: where a segment ends or starts, its derivatives there by t, and how far rounding of the
/// coordinates can have moved each.
struct JointSide {
  Vec2 position, first, second;
  RoundingError error;
  Vec2 tangent;          ///< unit; where `first` is all rounding, that of the next derivative (unit_tangent)
  double tangent_error;  ///< radians

  [[nodiscard]] double curvature() const;
  /// How much of the curvature the errors explain.
  [[nodiscard]] double curvature_error() const;
};

struct JointSides {
  JointSide before, after;
};

/// Both sides of the joint where `before` ends and `after` starts. `known_to`, a length, is what the coordinates of the
/// drawing are rounded to.
[[nodiscard]] JointSides sides_of(const Segment& before, const Segment& after, double known_to);

/// Relative accuracy that solvers are held to: 4096 roundings.
inline constexpr double solver_accuracy = 0x1p-40;

/// A relative jump, or an angle in radians, that no rounding explains away.
inline constexpr double visible_jump = 0.1;

/// What a joint misses of its claim.
struct JointMiss {
  enum class Of { position, tangent, curvature, first_derivative, second_derivative } of;
  double before, after;  ///< angles in radians and curvatures; 0 for vectors
  double measured, allowed;
};

/// Holds the two sides against the claim, for a curve whose points are `chord` apart on average. Allowed is what the
/// errors of the sides explain and, for what a solver had to find, `solver_accuracy` of the larger side (or of 1 /
/// chord, of chord for derivatives). More than a tenth is never explained: such a joint cannot be said to be smooth.
[[nodiscard]] std::optional<JointMiss> miss_of(const JointSides& sides, Continuity claimed, double chord);

/// Whether the control points of two Bézier segments show at a glance that the joint between them keeps its claim:
/// miss_of finds nothing then. False says nothing. Most joints of most curves are done with this.
[[nodiscard]] bool plainly_keeps(std::span<const Vec2> before, std::span<const Vec2> after, Continuity claimed,
                                 double chord);

}  // namespace kappabench
