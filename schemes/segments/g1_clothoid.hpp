#pragma once

#include <optional>

#include "schemes/curve/exact_form.hpp"

namespace kappabench {

/// A clothoid seen from its chord, which is taken as the unit of length: u in [0, 1] along it, its heading against the
/// chord is start + (end - start - shape) u + shape u^2.
struct G1Clothoid {
  double start, end;  ///< headings at both ends, radians
  double shape;       ///< A of Bertolazzi and Frego 2015
  double along;       ///< the chord over the length

  /// By how much the heading turns in all, left and right turns added.
  [[nodiscard]] double turn() const;
};

/// The one clothoid with these headings against its chord, both in [-pi, pi] (Bertolazzi and Frego 2015), and its
/// smooth continuation up to 5/4 pi while they are less than 2 pi apart, where the length grows beyond all bounds.
/// Newton on one equation, each step shortened until it helps, to rounding; nullopt if that stalls.
[[nodiscard]] std::optional<G1Clothoid> g1_clothoid(double start, double end);

/// The same between two points with headings against the x axis, each taken within half a turn of the chord. The points
/// must not coincide.
[[nodiscard]] std::optional<ClothoidForm> g1_clothoid(const Vec2& from, double start, const Vec2& to, double end);

}  // namespace kappabench
