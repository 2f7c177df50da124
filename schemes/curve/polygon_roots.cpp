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
struct Coordinates {
  std::vector<Number> x, y, weights;
};

template <class Number>
HodographForms<Number> hodograph(const ControlPolygon& polygon, const Coordinates<Number>& of) {
  const std::span<const Number> x(of.x), y(of.y), weights(of.weights);
  if (!weights.empty()) return rational_hodograph(x, y, weights);
  return polygon.trigonometric ? trigonometric_hodograph(x, y) : polynomial_hodograph(x, y);
}

int exponent_of(double largest) { return largest > 0.0 && std::isfinite(largest) ? std::ilogb(largest) : 0; }

/// `coordinate_error` in half units of the last place: 0 takes the control points as exact.
HodographForms<Bounded> bounded_hodograph(const ControlPolygon& polygon, double coordinate_error = 0.0) {
  // A power of two as the unit keeps products of many coordinates away from overflow, and is exact.
  double size = 0.0;
  for (const Vec2& p : polygon.points) size = std::max(size, (p - polygon.points.front()).cwiseAbs().maxCoeff());
  const auto bounded = [coordinate_error](double value, int unit) {
    const double scaled = std::ldexp(value, -unit);
    return Bounded(scaled, coordinate_error * 0x1p-53 * std::abs(scaled));
  };
  Coordinates<Bounded> of;
  for (const Vec2& p : polygon.points) {
    of.x.push_back(bounded(p.x(), exponent_of(size)));
    of.y.push_back(bounded(p.y(), exponent_of(size)));
  }
  for (const double weight : polygon.weights)
    of.weights.push_back(bounded(weight, exponent_of(std::ranges::max(polygon.weights))));
  return hodograph(polygon, of);
}

/// In units of the least power of two that all of `values` need; any unit will do, so that x and y have one together.
std::vector<Integer> as_integers(std::span<const double> values) {
  int least = 2000;
  for (const double c : values)
    if (c != 0.0) least = std::min(least, std::ilogb(c) - 52);
  std::vector<Integer> integers;
  integers.reserve(values.size());
  for (const double c : values) {
    const int exponent = c == 0.0 ? least : std::ilogb(c) - 52;
    integers.push_back(Integer(static_cast<long long>(std::ldexp(c, -exponent)))
                       << static_cast<unsigned>(exponent - least));
  }
  return integers;
}

HodographForms<Integer> integer_hodograph(const ControlPolygon& polygon) {
  std::vector<double> both;
  for (const Vec2& p : polygon.points) both.insert(both.end(), {p.x(), p.y()});
  const std::vector<Integer> integers = as_integers(both);
  Coordinates<Integer> of;
  for (std::size_t i = 0; i < integers.size(); i += 2) {
    of.x.push_back(integers[i]);
    of.y.push_back(integers[i + 1]);
  }
  of.weights = as_integers(polygon.weights);
  return hodograph(polygon, of);
}

/// d/dt of |c'|^2 up to a positive factor, c' being (x, y) / omega^e but for a factor: for rational segments e = 2, and
/// (D / omega^4)' = (D' omega - 4 D omega') / omega^5. The positive omega of the others hides no rest.
template <class Number>
BinaryForm<Number> slowing(const HodographForms<Number>& forms, bool rational) {
  const auto slope = [](const BinaryForm<Number>& form) { return difference(partial_t(form), partial_s(form)); };
  const BinaryForm<Number> d = forms.speed_squared();
  if (!rational) return slope(d);
  return difference(product(slope(d), forms.omega), scaled(product(d, slope(forms.omega)), 4));
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
  return std::ranges::all_of(points, [](const Vec2& p) { return p.allFinite(); }) &&
         std::ranges::all_of(weights, [](double w) { return w > 0.0 && std::isfinite(w); });
}

std::optional<ControlPolygon> control_polygon(const ExactForm& form) {
  if (const auto* polynomial = std::get_if<PolynomialForm>(&form)) return ControlPolygon{polynomial->control_points};
  if (const auto* trigonometric = std::get_if<TrigonometricForm>(&form)) {
    return ControlPolygon{{trigonometric->control_points.begin(), trigonometric->control_points.end()}, true};
  }
  if (const auto* rational = std::get_if<RationalForm>(&form))
    return ControlPolygon{rational->control_points, false, rational->weights};
  return std::nullopt;
}

SignChanges polygon_sign_changes(const ControlPolygon& polygon, bool of_slope) {
  return sign_changes(polygon,
                      [of_slope](const auto& forms) { return of_slope ? forms.slope() : forms.curvature_numerator(); });
}

std::vector<RootBracket> polygon_slow_places(const ControlPolygon& polygon) {
  const bool rational = !polygon.weights.empty();
  const BinaryForm<Bounded> squared = bounded_hodograph(polygon).speed_squared();
  double largest = 0.0;
  for (const Bounded& c : squared) largest = std::max(largest, std::abs(c.value));
  // The fourth power of omega divides |c'|^2.
  double limit = surely_fast * largest;
  if (rational) limit *= std::pow(std::ranges::max(polygon.weights) / std::ranges::min(polygon.weights), 4);
  const bool never_slow = std::ranges::all_of(squared, [limit](const Bounded& c) { return c.value - c.error > limit; });
  if (never_slow || squared.size() < 2) return {};
  return sign_changes(polygon, [rational](const auto& forms) { return slowing(forms, rational); }).at;
}

}  // namespace kappabench
