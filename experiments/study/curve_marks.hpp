#pragma once

#include "reports/store/model.hpp"
#include "schemes/curve/jet.hpp"

namespace kappabench {

/// Drawings over a drawn curve, as curves of a cell of their own: they hold samples of the plane and nothing else, and
/// take the colour of their cell's label.

/// The samples of `whole` from arc length s0 to s1 > s0. On a closed curve s1 may be beyond the end, and s0 before the
/// start, by up to the length. Samples only: the stretch ends at the samples next to s0 and s1.
[[nodiscard]] store::CurveRecord stretch_of(const store::CurveRecord& whole, double s0, double s1);

/// A regular polygon around a place: 4 corners are a diamond, many a circle.
[[nodiscard]] store::CurveRecord ring_around(const Vec2& centre, double radius, int corners);

}  // namespace kappabench
