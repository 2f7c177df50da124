#include "schemes/curve/exact_curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "schemes/curve/hodograph_forms.hpp"
#include "schemes/curve/intrinsic_roots.hpp"

namespace kappabench {
namespace {

constexpr double cusp_speed = 1e-8;           // over the mean speed
constexpr double widest_fast_bracket = 1e-9;  // its middle is much closer to the root
/// A form whose every coefficient is this close to 0, in bounds that allow for control points rounded to doubles, is
/// the zero function.
constexpr double noise_in_bounds = 4.0;

/// Polynomial and trigonometric segments: both are planar control polygons.
struct ControlPolygon {
  std::vector<Vec2> points;
  bool trigonometric = false;
};

std::optional<ControlPolygon> control_polygon(const ExactForm& form) {
  if (const auto* polynomial = std::get_if<PolynomialForm>(&form)) return ControlPolygon{polynomial->control_points};
  if (const auto* trigonometric = std::get_if<TrigonometricForm>(&form)) {
    return ControlPolygon{{trigonometric->control_points.begin(), trigonometric->control_points.end()}, true};
  }
  return std::nullopt;
}

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

bool finite(const ControlPolygon& polygon) {
  return std::all_of(polygon.points.begin(), polygon.points.end(), [](const Vec2& p) { return p.allFinite(); });
}

/// What is sampled of blends and opaque segments, with the level that counts as zero.
struct SampledFunction {
  std::array<double, 257> value{};
  double noise = 0.0;
};

constexpr double step = 1.0 / 256.0;

double mean_speed(std::span<const Jet> jets) {
  double sum = 0.0;
  for (const Jet& jet : jets) sum += speed(jet);
  return sum / static_cast<double>(jets.size());
}

std::array<Jet, 257> sample(const Segment& segment, int order) {
  std::array<double, 257> t{};
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = static_cast<double>(i) * step;
  std::array<Jet, 257> jets;
  segment.jets(t, order, jets);
  return jets;
}

/// d kappa / dt, or kappa over the length of the segment; noise is 1e-9 of the largest curvature or of 1 / length.
double sampled_value(const Jet& jet, bool of_slope) {
  return of_slope ? curvature_derivative(jet) * speed(jet) : curvature(jet);
}

SignChanges sampled_sign_changes(const Segment& segment, bool of_slope) {
  const int order = of_slope ? 3 : 2;
  const std::array<Jet, 257> jets = sample(segment, order);
  const double length = mean_speed(jets);
  SignChanges result{{}, false, true};
  if (!(length > 0.0) || !std::isfinite(length)) return result;
  double largest = 1.0 / length;
  for (const Jet& jet : jets) {
    const double kappa = std::abs(curvature(jet));
    if (std::isfinite(kappa)) largest = std::max(largest, kappa);
  }
  const double noise = 1e-9 * largest;
  int sign_before = 0;
  double t_before = 0.0;
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const double value = sampled_value(jets[i], of_slope);
    if (!(std::abs(value) > noise)) continue;
    const int sign = value > 0.0 ? 1 : -1;
    const double t = static_cast<double>(i) * step;
    if (sign_before != 0 && sign != sign_before) {
      RootBracket bracket{t_before, t};
      while (bracket.hi - bracket.lo > 1e-15) {
        const double mid = bracket.mid();
        const double at_mid = sampled_value(segment.jet(mid, order), of_slope);
        if (!(mid > bracket.lo && mid < bracket.hi) || std::isnan(at_mid)) break;
        ((at_mid > 0.0) == (sign_before > 0) ? bracket.lo : bracket.hi) = mid;
      }
      result.at.push_back(bracket);
    }
    sign_before = sign;
    t_before = t;
    result.vanishes = false;
  }
  return result;
}

/// Local minima of the sampled speed, refined by bisection of the sign of c' . c''.
std::vector<double> sampled_cusps(const Segment& segment) {
  const std::array<Jet, 257> jets = sample(segment, 2);
  const double mean = mean_speed(jets);
  const auto slowing = [&](const Jet& jet) { return jet.d[1].dot(jet.d[2]) < 0.0; };
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < jets.size(); ++i) {
    if (!slowing(jets[i]) || slowing(jets[i + 1])) continue;
    double lo = static_cast<double>(i) * step;
    double hi = lo + step;
    while (hi - lo > 1e-15) {
      const double mid = 0.5 * (lo + hi);
      if (mid <= lo || mid >= hi) break;
      (slowing(segment.jet(mid, 2)) ? lo : hi) = mid;
    }
    const double t = 0.5 * (lo + hi);
    if (t > 0.0 && t < 1.0 && speed(segment.jet(t, 1)) <= cusp_speed * mean) found.push_back(t);
  }
  return found;
}

std::vector<double> polygon_cusps(const Segment& segment, const ControlPolygon& polygon) {
  const BinaryForm<Bounded> squared = bounded_hodograph(polygon).speed_squared();
  double largest = 0.0;
  for (const Bounded& c : squared) largest = std::max(largest, std::abs(c.value));
  const bool never_slow =
      std::all_of(squared.begin(), squared.end(), [&](const Bounded& c) { return c.value > 1e-12 * largest; });
  if (never_slow || squared.size() < 2) return {};
  const SignChanges turning = sign_changes(polygon, [](const auto& forms) {
    const auto d = forms.speed_squared();
    return difference(partial_t(d), partial_s(d));
  });
  const double mean = mean_speed(sample(segment, 1));
  std::vector<double> found;
  for (const RootBracket& bracket : turning.at) {
    if (speed(segment.jet(bracket.mid(), 1)) <= cusp_speed * mean) found.push_back(bracket.mid());
  }
  return found;
}

/// kappa = a x b / |c'|^3, and |c'|^2 = mean - amplitude cos(2 w - phase): kappa is extreme where 2 w - phase is a
/// multiple of pi.
SignChanges elliptic_sign_changes(const EllipticArcForm& form, bool of_slope) {
  SignChanges result;
  const double aa = form.axis_a.squaredNorm(), bb = form.axis_b.squaredNorm(), ab = form.axis_a.dot(form.axis_b);
  const double amplitude = std::hypot(0.5 * (aa - bb), ab), rounding = 8.0 * 0x1p-52;
  const bool straight = std::abs(cross(form.axis_a, form.axis_b)) <= rounding * std::sqrt(aa * bb);
  result.vanishes = straight || (of_slope && amplitude <= rounding * (aa + bb)) || form.from == form.to;
  if (result.vanishes || !of_slope || !std::isfinite(amplitude + form.from + form.to)) return result;
  const double phase = std::atan2(ab, 0.5 * (aa - bb)), half_turn = std::numbers::pi;
  const double first = (2.0 * std::min(form.from, form.to) - phase) / half_turn;
  const double last = (2.0 * std::max(form.from, form.to) - phase) / half_turn;
  for (auto k = std::lround(std::ceil(first)); k <= std::lround(std::floor(last)); ++k) {
    const double t = (0.5 * (static_cast<double>(k) * half_turn + phase) - form.from) / (form.to - form.from);
    // One at an end is the joint's, not the segment's; rounding must not move it inside.
    if (t > 1e-14 && t < 1.0 - 1e-14) result.at.push_back({t, t});
  }
  if (form.to < form.from) std::reverse(result.at.begin(), result.at.end());
  return result;
}

SignChanges changes_of(const Segment& segment, bool of_slope);

/// The sign changes of the other parameter x, taken back to t = x / (m - (m - 1) x).
SignChanges reparametrized_sign_changes(const ReparametrizedForm& form, bool of_slope) {
  SignChanges result = changes_of(*form.of, of_slope);
  const double m = form.start_speed;
  for (RootBracket& bracket : result.at)
    for (double* x : {&bracket.lo, &bracket.hi}) *x = *x / (m - (m - 1.0) * *x);
  return result;
}

SignChanges changes_of(const Segment& segment, bool of_slope) {
  const ExactForm form = segment.exact();
  if (const auto polygon = control_polygon(form)) {
    if (!finite(*polygon)) return {};
    return sign_changes(
        *polygon, [of_slope](const auto& forms) { return of_slope ? forms.slope() : forms.curvature_numerator(); });
  }
  if (const auto* clothoid = std::get_if<ClothoidForm>(&form)) return clothoid_sign_changes(*clothoid, of_slope);
  if (const auto* intrinsic = std::get_if<IntrinsicForm>(&form)) return intrinsic_sign_changes(*intrinsic, of_slope);
  if (const auto* arc = std::get_if<EllipticArcForm>(&form)) return elliptic_sign_changes(*arc, of_slope);
  if (const auto* same = std::get_if<ReparametrizedForm>(&form)) return reparametrized_sign_changes(*same, of_slope);
  return sampled_sign_changes(segment, of_slope);
}

}  // namespace

SignChanges curvature_extrema(const Segment& segment) { return changes_of(segment, true); }

SignChanges inflections(const Segment& segment) { return changes_of(segment, false); }

std::vector<double> cusps(const Segment& segment) {
  const ExactForm form = segment.exact();
  if (const auto polygon = control_polygon(form)) {
    return finite(*polygon) ? polygon_cusps(segment, *polygon) : std::vector<double>{};
  }
  const bool regular = std::holds_alternative<ClothoidForm>(form) || std::holds_alternative<IntrinsicForm>(form);
  return regular ? std::vector<double>{} : sampled_cusps(segment);
}

}  // namespace kappabench
