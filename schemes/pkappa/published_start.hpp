#pragma once

#include "schemes/pkappa/window.hpp"

namespace kappabench::pkappa {

/// The starts of Wang 2024, Section 5.2, with the repairs that README.md lists. They need not satisfy every constraint:
/// solve_window restores interpolation.

/// |p q| / (|p q| + |q r|); 1/2 if all coincide.
[[nodiscard]] double chord_parameter(const Vec2& p, const Vec2& q, const Vec2& r);

/// The part of a segment on [a, b], 0 <= a < b <= 1 (de Casteljau at both ends).
template <int Degree>
[[nodiscard]] ControlPolygon<Degree> part(ControlPolygon<Degree> control, double a, double b);

/// The first segment: the quadratic through three points at 0, t and 1, elevated.
template <int Degree>
[[nodiscard]] ControlPolygon<Degree> first_segment(const Vec2& start, const Vec2& point, const Vec2& end, double t);

/// Section 5.2.1: a last segment that continues `before` with C1 (quartic) or C2 (quintic), passes `point` at t and
/// ends at `end` with c_{k-1} = (c_{k-2} + c_k) / 2.
template <Continuity K>
[[nodiscard]] ControlPolygon<Layout<K>::degree> last_segment(const ControlPolygon<Layout<K>::degree>& before,
                                                             const Vec2& point, const Vec2& end, double t);

/// Section 5.2.1, parametric continuity: moves the joint of two polygons and, for C2, c_2 of the right one. Does
/// nothing for geometric continuity.
template <Continuity K>
void make_parametric(ControlPolygon<Layout<K>::degree>& left, ControlPolygon<Layout<K>::degree>& right);

/// Section 5.2.2: a new segment through `point` between two that give way: `left` keeps [0, (1 + t) / 2], `right` keeps
/// [t / 2, 1]; t are `left_t` and `right_t`. Returns the three segments.
template <Continuity K>
[[nodiscard]] Spline<K> between(const ControlPolygon<Layout<K>::degree>& left, double left_t, const Vec2& left_point,
                                const Vec2& point, const ControlPolygon<Layout<K>::degree>& right, double right_t,
                                const Vec2& right_point);

}  // namespace kappabench::pkappa
