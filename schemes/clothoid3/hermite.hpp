#pragma once

#include <array>
#include <optional>

#include "schemes/curve/exact_form.hpp"

namespace kappabench::clothoid3 {

/// Where a curve passes, in which direction (radians) and with which signed curvature.
struct CurveElement {
  Vec2 point;
  double heading;
  double curvature;
};

/// Three clothoids with continuous curvature and the given headings and curvatures at both ends.
struct ThreeArcs {
  std::array<ClothoidForm, 3> arcs;
  int iterations;   ///< of Newton's method
  double residual;  ///< gap that is left between the second and third arc, over half the chord
};

/// Bertolazzi and Frego 2018: the lengths of the outer arcs are fixed from the G1 clothoid; length and middle heading
/// of the arc between solve two equations. Newton with the exact Jacobian, each step shortened until the residual
/// falls; nullopt if it ends above 1e-10, or if a rate of curvature is too large for a double.
[[nodiscard]] std::optional<ThreeArcs> three_arcs(const CurveElement& from, const CurveElement& to);

}  // namespace kappabench::clothoid3
