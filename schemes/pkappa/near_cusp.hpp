#pragma once

#include <optional>

#include "schemes/pkappa/segment_energy.hpp"

namespace kappabench::pkappa {

/// Where a Bézier segment all but stops and turns: the parameter, to 1e-9, of a point where |c'| is stationary and
/// |c'|^2 < width^2 |c''|^2 + rest^2, if there is one. Where there is none, |c'| is nowhere below `rest` but where it
/// is so at an end. With rest = 0, c' and c'' are orthogonal there, so that the direction turns by about a right
/// angle within `width` to either side and the curvature is |c''| / |c'|^2. Certain up to rounding of the control
/// points: by signs of Bernstein coefficients and subdivision.
template <int Degree>
[[nodiscard]] std::optional<double> near_cusp(const ControlPolygon<Degree>& control, double width, double rest = 0.0);

}  // namespace kappabench::pkappa
