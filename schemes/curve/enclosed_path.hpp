#pragma once

#include <array>
#include <functional>

#include "schemes/curve/exact_form.hpp"
#include "schemes/numerics/interval.hpp"
#include "schemes/numerics/taylor_series.hpp"

namespace kappabench {

/// Enough for the derivative of d kappa / dt.
inline constexpr std::size_t enclosed_order = 4;

using IntervalSeries = TaylorSeries<Interval, enclosed_order + 1>;

/// Both coordinates, over an interval of the parameter.
using EnclosedPoint = std::array<IntervalSeries, 2>;

/// A segment as a map of Taylor series in interval arithmetic: from those of its parameter to those of its coordinates,
/// counted from some origin.
using EnclosedPath = std::function<EnclosedPoint(const IntervalSeries&)>;

/// Polynomials, circular arcs, elliptical arcs, and blends and reparametrisations of what is enclosed. Empty for all
/// others, and where a number is not finite.
[[nodiscard]] EnclosedPath enclosed_path(const ExactForm& form, const Vec2& origin);

/// The parameter itself over an interval.
[[nodiscard]] IntervalSeries parameter_over(const Interval& t);

}  // namespace kappabench
