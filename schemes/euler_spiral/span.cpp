#include "schemes/euler_spiral/span.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "schemes/segments/clothoid.hpp"

namespace kappabench::euler_spiral {

std::optional<Span> span_between(double start, double end) {
  constexpr double pi = std::numbers::pi;
  const bool within = std::max(std::abs(start), std::abs(end)) <= 1.25 * pi && std::abs(end - start) < 2.0 * pi;
  if (!within) return std::nullopt;
  const auto found = g1_clothoid(start, end);
  if (!found) return std::nullopt;
  const double delta = end - start, A = found->shape, along = found->along;
  // The end for unit length, z = integral of exp(i (start + (delta - A) u + A u^2)), lies on the chord: Im z = 0, Re z
  // = along. So dA follows from d Im z = 0. By start, end and A the phase changes by 1 - u, u and u^2 - u.
  const auto m = clothoid_moments(start, delta - A, 2.0 * A);
  const std::complex<double> by_start = m[0] - m[1], by_end = m[1], by_shape = m[2] - m[1];
  const double shape_by_start = -by_start.real() / by_shape.real(), shape_by_end = -by_end.real() / by_shape.real();
  const double along_by_start = -by_start.imag() - by_shape.imag() * shape_by_start;
  const double along_by_end = -by_end.imag() - by_shape.imag() * shape_by_end;
  // Curvatures times length are delta - A and delta + A.
  const auto curvature = [&](double side) {
    const double turning = delta + side * A;
    return EndCurvature{turning * along, (-1.0 + side * shape_by_start) * along + turning * along_by_start,
                        (1.0 + side * shape_by_end) * along + turning * along_by_end};
  };
  return Span{*found, curvature(-1.0), curvature(1.0)};
}

}  // namespace kappabench::euler_spiral
