#include "schemes/curve/polygon_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "schemes/curve/hodograph_forms.hpp"

namespace kappabench {
namespace {

constexpr double widest_fast_bracket = 1e-9;  // its middle is much closer to the root
/// A form whose every coefficient is this close to 0, in bounds that allow for control points rounded to doubles, is
/// the zero function.
constexpr double noise_in_bounds = 4.0;
/// Coefficients of |c'|^2 above this part of the largest one A keep it above 1e-16 of its mean: in degree 8 the basis
/// s^(8-i) t^i sums to 9/256 at least and to 1 at most, and the trigonometric form leaves out a factor within 2^6.
constexpr double surely_fast = 1e-12;

template <class Number>
HodographForms<Number> hodograph(const ControlPolygon& polygon, std::span<const Number> x, std::span<const Number> y) {
  return polygon.trigonometric ? trigonometric_hodograph(x, y) : polynomial_hodograph(x, y);
}

/// `coordinate_error` in half units of the last place: 0 takes the control points as exact.
HodographForms<Bounded> bounded_hodograph(const ControlPolygon& polygon, double coordinate_error = 0.0) {
  std::vector<Bounded> x;
  std::vector<Bounded> y;
  // A power of two as the unit keeps products of many coordinates away from overflow, and is exact.
  double size = 0.0;
  for (const Vec2& p : polygon.points) size = std::max(size, (p - polygon.points.front()).cwiseAbs().maxCoeff());
  const int unit = size > 0.0 && std::isfinite(size) ? std::ilogb(size) : 0;
  for (const Vec2& p : polygon.points) {
    const Vec2 q{std::ldexp(p.x(), -unit), std::ldexp(p.y(), -unit)};
    x.emplace_back(q.x(), coordinate_error * 0x1p-53 * std::abs(q.x()));
    y.emplace_back(q.y(), coordinate_error * 0x1p-53 * std::abs(q.y()));
  }
  return hodograph<Bounded>(polygon, x, y);
}

/// The coordinates as integers, in units of the least power of two that all of them need.
HodographForms<Integer> integer_hodograph(const ControlPolygon& polygon) {
  int least = 2000;
  for (const Vec2& p : polygon.points) {
    for (const double c : {p.x(), p.y()}) {
      if (c != 0.0) least = std::min(least, std::ilogb(c) - 52);
    }
  }
  const auto integer = [least](double c) {
    if (c == 0.0) return Integer(0);
    const int exponent = std::ilogb(c) - 52;
    return Integer(static_cast<long long>(std::ldexp(c, -exponent))) << static_cast<unsigned>(exponent - least);
  };
  std::vector<Integer> x;
  std::vector<Integer> y;
  for (const Vec2& p : polygon.points) {
    x.push_back(integer(p.x()));
    y.push_back(integer(p.y()));
  }
  return hodograph<Integer>(polygon, x, y);
}

/// From x = tan(pi t / 4) to t, widened by the rounding of the conversion.
RootBracket from_half_angle_tangent(const RootBracket& x) {
  const auto t = [](double v) { return 4.0 * std::numbers::inv_pi * std::atan(v); };
  constexpr double slack = 0x1p-51;
  return {std::max(0.0, t(x.lo) - slack), std::min(1.0, t(x.hi) + slack)};
}

bool vanishes_in_rounding(const BinaryForm<Bounded>& form) {
  return std::all_of(form.begin(), form.end(),
                     [](const Bounded& c) { return std::abs(c.value) <= noise_in_bounds * c.error; });
}

/// Sign changes of one of the forms of a polygon's hodograph: `pick(forms)` chooses which.
template <class Pick>
SignChanges sign_changes(const ControlPolygon& polygon, const Pick& pick) {
  SignChanges result;
  result.vanishes = vanishes_in_rounding(pick(bounded_hodograph(polygon, 1.0)));
  if (result.vanishes) return result;
  const auto found = isolate_sign_changes(pick(bounded_hodograph(polygon)));
  const bool narrow = found && std::all_of(found->begin(), found->end(),
                                           [](const RootBracket& b) { return b.hi - b.lo <= widest_fast_bracket; });
  result.at = narrow ? *found : isolate_sign_changes(pick(integer_hodograph(polygon)));
  if (polygon.trigonometric)
    std::transform(result.at.begin(), result.at.end(), result.at.begin(), from_half_angle_tangent);
  return result;
}

}  // namespace

bool ControlPolygon::finite() const {
  return std::all_of(points.begin(), points.end(), [](const Vec2& p) { return p.allFinite(); });
}

std::optional<ControlPolygon> control_polygon(const ExactForm& form) {
  if (const auto* polynomial = std::get_if<PolynomialForm>(&form)) return ControlPolygon{polynomial->control_points};
  if (const auto* trigonometric = std::get_if<TrigonometricForm>(&form)) {
    return ControlPolygon{{trigonometric->control_points.begin(), trigonometric->control_points.end()}, true};
  }
  return std::nullopt;
}

SignChanges polygon_sign_changes(const ControlPolygon& polygon, bool of_slope) {
  return sign_changes(polygon,
                      [of_slope](const auto& forms) { return of_slope ? forms.slope() : forms.curvature_numerator(); });
}

std::vector<RootBracket> polygon_slow_places(const ControlPolygon& polygon) {
  const BinaryForm<Bounded> squared = bounded_hodograph(polygon).speed_squared();
  double largest = 0.0;
  for (const Bounded& c : squared) largest = std::max(largest, std::abs(c.value));
  const bool never_slow = std::all_of(squared.begin(), squared.end(),
                                      [&](const Bounded& c) { return c.value - c.error > surely_fast * largest; });
  if (never_slow || squared.size() < 2) return {};
  const auto slowing = [](const auto& forms) {
    const auto d = forms.speed_squared();
    return difference(partial_t(d), partial_s(d));
  };
  return sign_changes(polygon, slowing).at;
}

}  // namespace kappabench
