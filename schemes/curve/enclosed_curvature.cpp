#include "schemes/curve/enclosed_curvature.hpp"

#include <algorithm>
#include <cmath>

#include "schemes/curve/enclosed_path.hpp"
#include "schemes/numerics/root_isolation_by_intervals.hpp"

namespace kappabench {
namespace {

constexpr double zero_in_terms = 0x1p-40;  // rounding is 0x1p-53 a term, and differences cost up to ten digits of it
/// Where everything is below this, the function is the zero function up to rounding, as in `sampled_sign_changes`.
constexpr double nearly_zero = 1e-9;
constexpr int looks = 16;

/// The first four derivatives of the position.
struct Derivatives {
  std::array<std::array<Interval, 2>, enclosed_order> d;

  explicit Derivatives(const EnclosedPoint& point) {
    double factorial = 1.0;
    for (std::size_t k = 1; k <= enclosed_order; ++k) {
      factorial *= static_cast<double>(k);
      for (std::size_t axis = 0; axis < 2; ++axis) d[k - 1][axis] = factorial * point[axis][k];
    }
  }
  [[nodiscard]] Interval dot(std::size_t i, std::size_t j) const {
    const auto &a = d[i - 1], &b = d[j - 1];
    return a[0] * b[0] + a[1] * b[1];
  }
  [[nodiscard]] Interval cross(std::size_t i, std::size_t j) const {
    const auto &a = d[i - 1], &b = d[j - 1];
    return a[0] * b[1] - a[1] * b[0];
  }
  [[nodiscard]] Interval squared(std::size_t i) const { return square(d[i - 1][0]) + square(d[i - 1][1]); }
  [[nodiscard]] double size(std::size_t i) const { return std::sqrt(squared(i).upper()); }
};

/// N = c' x c'', of the sign of kappa; N' = c' x c'''.
Enclosure curvature_numerator(const Derivatives& c) {
  const double v = c.size(1);
  return {c.cross(1, 2), c.cross(1, 3), zero_in_terms * v * (c.size(2) + v)};
}

/// d kappa / dt = S / |c'|^5 with S = N' D - 3 N E, D = |c'|^2, E = c' . c'' = D' / 2;
/// S' = N'' D - N' E - 3 N E', N'' = c'' x c''' + c' x c'''', E' = |c''|^2 + c' . c'''.
Enclosure slope_numerator(const Derivatives& c) {
  const Interval n = c.cross(1, 2), n1 = c.cross(1, 3), n2 = c.cross(2, 3) + c.cross(1, 4);
  const Interval d = c.squared(1), e = c.dot(1, 2), e1 = c.squared(2) + c.dot(1, 3);
  const double v = c.size(1), a = c.size(2);
  return {n1 * d - 3.0 * n * e, n2 * d - n1 * e - 3.0 * n * e1,
          zero_in_terms * v * v * (v * c.size(3) + 3.0 * a * a + v * v)};
}

EnclosedFunction speed_squared(const EnclosedPath& path) {
  return [&path](const Interval& t) -> Enclosure {
    const Derivatives c(path(parameter_over(t)));
    return {c.squared(1), 2.0 * c.dot(1, 2), 0.0};
  };
}

Vec2 origin_of(const Segment& segment) { return segment.jet(0.5, 0).position(); }

/// Nothing at a few places is more than nearly zero: there is nothing to prove, or it is not finite.
bool nowhere_large(const EnclosedFunction& f) {
  for (int i = 0; i <= looks; ++i) {
    const Enclosure at = f(Interval(static_cast<double>(i) / looks));
    if (largest(at.value) > at.noise * (nearly_zero / zero_in_terms)) return false;
  }
  return true;
}

}  // namespace

std::optional<SignChanges> enclosed_sign_changes(const Segment& segment, bool of_slope) {
  const EnclosedPath path = enclosed_path(segment.exact(), origin_of(segment));
  if (!path) return std::nullopt;
  const EnclosedFunction f = [&](const Interval& t) {
    const Derivatives c(path(parameter_over(t)));
    return of_slope ? slope_numerator(c) : curvature_numerator(c);
  };
  if (nowhere_large(f)) return std::nullopt;
  const auto found = isolate_sign_changes(f);
  if (!found) return std::nullopt;
  return SignChanges{*found, Certification::enclosed, false};
}

bool speed_stays_above(const Segment& segment, double least) {
  const EnclosedPath path = enclosed_path(segment.exact(), origin_of(segment));
  return path && stays_above(speed_squared(path), least * least);
}

}  // namespace kappabench
