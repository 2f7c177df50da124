#include "schemes/curve/enclosed_path.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "schemes/curve/segment.hpp"

namespace kappabench {
namespace {

using IntervalVector = std::array<Interval, 2>;

constexpr std::array<std::size_t, 2> axes{0, 1};

IntervalVector from_origin(const Vec2& p, const Vec2& origin) {
  return {Interval(p.x()) - origin.x(), Interval(p.y()) - origin.y()};
}

Interval pi() { return boost::numeric::interval_lib::pi<Interval>(); }

/// Bernstein's form in powers of the parameter: coefficient k is binomial(n, k) times the k-th forward difference.
EnclosedPath path_of(const PolynomialForm& form, const Vec2& origin) {
  const std::size_t count = form.control_points.size();
  if (count == 0) return {};
  std::vector<IntervalVector> power;
  for (const Vec2& p : form.control_points) power.push_back(from_origin(p, origin));
  for (std::size_t k = 1; k < count; ++k)
    for (std::size_t i = count - 1; i >= k; --i)
      for (const std::size_t axis : axes) power[i][axis] -= power[i - 1][axis];
  double binomial = 1.0;
  for (std::size_t k = 1; k < count; ++k) {
    binomial = binomial * static_cast<double>(count - k) / static_cast<double>(k);
    for (const std::size_t axis : axes) power[k][axis] *= binomial;
  }
  return [power](const IntervalSeries& t) {
    EnclosedPoint point{};
    for (const std::size_t axis : axes) {
      point[axis][0] = power.back()[axis];
      for (std::size_t k = power.size() - 1; k-- > 0;) {
        point[axis] = product(point[axis], t);
        point[axis][0] += power[k][axis];
      }
    }
    return point;
  };
}

EnclosedPath path_of(const EllipticArcForm& form, const Vec2& origin) {
  const IntervalVector centre = from_origin(form.centre, origin);
  const Interval rate = Interval(form.to) - form.from;
  return [form, centre, rate](const IntervalSeries& t) {
    const auto [cosine, sine] = cosine_and_sine(affine(rate, t, Interval(form.from)));
    const Interval none(0.0);
    return EnclosedPoint{
        affine(Interval(1.0),
               sum(affine(Interval(form.axis_a.x()), cosine, none), affine(Interval(form.axis_b.x()), sine, none)),
               centre[0]),
        affine(Interval(1.0),
               sum(affine(Interval(form.axis_a.y()), cosine, none), affine(Interval(form.axis_b.y()), sine, none)),
               centre[1])};
  };
}

/// sin x / x, which falls from 1 to 0 between 0 and pi.
Interval sine_quotient(const Interval& x) {
  const auto at = [](double v) -> Interval {
    const Interval square = Interval(v) * v;
    // The alternating series is between its partial sums.
    if (v < 0x1p-8) return 1.0 - square / 6.0 + square * square * Interval(0.0, 1.0 / 120.0);
    return sin(Interval(v)) / v;
  };
  const Interval size = abs(x);
  if (!(size.upper() < 3.0)) return {-0.25, 1.0};
  return {at(size.upper()).lower(), std::min(1.0, at(size.lower()).upper())};
}

/// A circular arc, or a line: after s = L t it is s sin(h) / h away, h = kappa s / 2, in the direction angle + h. The
/// further coefficients are those of the integral of the tangent.
EnclosedPath path_of(const ClothoidForm& form, const Vec2& origin) {
  if (form.curvature_rate != 0.0) return {};
  const IntervalVector start = from_origin(form.start, origin);
  return [form, start](const IntervalSeries& t) {
    const IntervalSeries s = affine(Interval(form.length), t, Interval(0.0));
    const Interval half = 0.5 * form.curvature * s[0], middle = half + form.angle;
    const Interval far = s[0] * sine_quotient(half);
    const auto [cosine, sine] = cosine_and_sine(affine(Interval(form.curvature), s, Interval(form.angle)));
    const IntervalSeries speed = derivative(s);
    return EnclosedPoint{integral(product(cosine, speed), start[0] + far * cos(middle)),
                         integral(product(sine, speed), start[1] + far * sin(middle))};
  };
}

EnclosedPath path_of(const BlendForm& form, const Vec2& origin) {
  EnclosedPath from = enclosed_path(form.from->exact(), origin), to = enclosed_path(form.to->exact(), origin);
  if (!from || !to) return {};
  return [from = std::move(from), to = std::move(to)](const IntervalSeries& t) {
    // sin^2(pi t / 2).
    const IntervalSeries weight =
        affine(Interval(-0.5), cosine_and_sine(affine(pi(), t, Interval(0.0))).cosine, Interval(0.5));
    const EnclosedPoint a = from(t), b = to(t);
    return EnclosedPoint{sum(a[0], product(weight, difference(b[0], a[0]))),
                         sum(a[1], product(weight, difference(b[1], a[1])))};
  };
}

EnclosedPath path_of(const ReparametrizedForm& form, const Vec2& origin) {
  EnclosedPath of = enclosed_path(form.of->exact(), origin);
  if (!of || !std::isfinite(form.start_speed)) return {};
  return [of = std::move(of), m = Interval(form.start_speed)](const IntervalSeries& t) {
    // x = m t / (1 + (m - 1) t) rises with t, and x' = m t' / (1 + (m - 1) t)^2.
    const auto at = [&](double v) { return m * v / (1.0 + (m - 1.0) * v); };
    const Interval x(at(t[0].lower()).lower(), at(t[0].upper()).upper());
    IntervalSeries one{};
    one[0] = Interval(1.0);
    const IntervalSeries inverse = quotient(one, affine(m - 1.0, t, Interval(1.0)));
    const IntervalSeries slope = product(derivative(t), product(inverse, inverse));
    return of(integral(affine(m, slope, Interval(0.0)), x));
  };
}

EnclosedPath path_of(const RationalForm&, const Vec2&) { return {}; }
EnclosedPath path_of(const TrigonometricForm&, const Vec2&) { return {}; }
EnclosedPath path_of(const IntrinsicForm&, const Vec2&) { return {}; }
EnclosedPath path_of(const SampledForm&, const Vec2&) { return {}; }
EnclosedPath path_of(const OpaqueForm&, const Vec2&) { return {}; }

}  // namespace

EnclosedPath enclosed_path(const ExactForm& form, const Vec2& origin) {
  return std::visit([&](const auto& known) { return path_of(known, origin); }, form);
}

IntervalSeries parameter_over(const Interval& t) {
  IntervalSeries series{};
  series[0] = t;
  series[1] = Interval(1.0);
  return series;
}

}  // namespace kappabench
