#include "schemes/curve/exact_curvature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/differentiation/autodiff.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "schemes/segments/blend.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/elliptic_arc.hpp"
#include "schemes/segments/intrinsic.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/rational.hpp"
#include "schemes/segments/reparametrized.hpp"
#include "schemes/segments/trigonometric.hpp"
#include "tests/catch.hpp"
#include "tests/sanitized.hpp"

using namespace kappabench;

// The oracle: the formulas of exact_form.hpp once more, in long double, differentiated by Boost.Math's autodiff.

namespace {

using Real = long double;
using Variable = boost::math::differentiation::autodiff_fvar<Real, 3>;
using Point = std::array<Variable, 2>;

constexpr Real pi = std::numbers::pi_v<Real>;

Point at(const ExactForm& form, const Variable& t);

Point at(const PolynomialForm& form, const Variable& t) {
  std::vector<Point> row;
  for (const Vec2& p : form.control_points) row.push_back({Variable(p.x()), Variable(p.y())});
  for (std::size_t left = row.size() - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i)
      for (const std::size_t axis : {0U, 1U}) row[i][axis] += t * (row[i + 1][axis] - row[i][axis]);
  return row[0];
}

Point at(const RationalForm& form, const Variable& t) {
  const std::size_t degree = form.weights.size() - 1;
  Variable x(0), y(0), sum(0);
  Real binomial = 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    Variable basis(binomial * static_cast<Real>(form.weights[i]));
    for (std::size_t k = 0; k < degree; ++k) basis *= k < i ? t : 1 - t;
    x += static_cast<Real>(form.control_points[i].x()) * basis;
    y += static_cast<Real>(form.control_points[i].y()) * basis;
    sum += basis;
    binomial = binomial * static_cast<Real>(degree - i) / static_cast<Real>(i + 1);
  }
  return {x / sum, y / sum};
}

Point at(const TrigonometricForm& form, const Variable& t) {
  const Variable s = sin(pi / 2 * t), c = cos(pi / 2 * t), u = 1 - s, v = s + c - 1, w = 1 - c;
  const std::array<Variable, 5> basis{u * u, 2 * u * v, 4 * u * w, 2 * v * w, w * w};
  Point sum{Variable(0), Variable(0)};
  for (std::size_t i = 0; i < 5; ++i) {
    sum[0] += static_cast<Real>(form.control_points[i].x()) * basis[i];
    sum[1] += static_cast<Real>(form.control_points[i].y()) * basis[i];
  }
  return sum;
}

/// Circular arcs alone: those that a blend may have.
Point at(const ClothoidForm& form, const Variable& t) {
  const Variable s = static_cast<Real>(form.length) * t, half = static_cast<Real>(form.curvature) / 2 * s;
  const Variable far = form.curvature == 0.0 ? s : Variable(s * sin(half) / half);
  const Variable heading = half + static_cast<Real>(form.angle);
  return {static_cast<Real>(form.start.x()) + far * cos(heading),
          static_cast<Real>(form.start.y()) + far * sin(heading)};
}

Point at(const EllipticArcForm& form, const Variable& t) {
  const Variable w = static_cast<Real>(form.from) + (static_cast<Real>(form.to) - static_cast<Real>(form.from)) * t;
  const Variable c = cos(w), s = sin(w);
  const auto axis = [&](double centre, double a, double b) -> Variable {
    return static_cast<Real>(centre) + static_cast<Real>(a) * c + static_cast<Real>(b) * s;
  };
  return {axis(form.centre.x(), form.axis_a.x(), form.axis_b.x()),
          axis(form.centre.y(), form.axis_a.y(), form.axis_b.y())};
}

Point at(const BlendForm& form, const Variable& t) {
  const Variable weight = (1 - cos(pi * t)) / 2;
  const Point from = at(form.from->exact(), t), to = at(form.to->exact(), t);
  return {from[0] + weight * (to[0] - from[0]), from[1] + weight * (to[1] - from[1])};
}

Point at(const ReparametrizedForm& form, const Variable& t) {
  const auto m = static_cast<Real>(form.start_speed);
  return at(form.of->exact(), m * t / (1 + (m - 1) * t));
}

Point at(const IntrinsicForm&, const Variable&) { throw std::logic_error("has no closed position"); }
Point at(const SampledForm&, const Variable&) { throw std::logic_error("has no formula"); }
Point at(const OpaqueForm&, const Variable&) { throw std::logic_error("has no formula"); }

Point at(const ExactForm& form, const Variable& t) {
  return std::visit([&](const auto& known) { return at(known, t); }, form);
}

/// A function that changes sign with the curvature or its slope, and the size of its terms.
struct Value {
  Real value, terms;
};
struct Signs {
  Value curvature, slope;
};

Signs from_position(const ExactForm& form, Real t) {
  const Point p = at(form, boost::math::differentiation::make_fvar<Real, 3>(t));
  const auto d = [&](std::size_t axis, std::size_t order) { return p[axis].derivative(order); };
  const auto cross_of = [&](std::size_t i, std::size_t j) { return d(0, i) * d(1, j) - d(1, i) * d(0, j); };
  const auto size = [&](std::size_t i) { return std::hypot(d(0, i), d(1, i)); };
  const Real n = cross_of(1, 2), n1 = cross_of(1, 3), v = size(1), a = size(2);
  const Real e = d(0, 1) * d(0, 2) + d(1, 1) * d(1, 2);
  return {{n, v * (a + v)}, {n1 * v * v - 3 * n * e, v * v * (v * size(3) + 3 * a * a + v * v)}};
}

/// De Boor's rule on the reduced knots, in which control i is the polar form at knots i to i + degree - 1.
Real spline(const std::vector<Real>& control, std::span<const double> knots, std::size_t degree, Real t) {
  std::size_t first = 0;  // control of the span that holds t
  while (first + degree + 1 < control.size() && static_cast<Real>(knots[first + degree]) <= t) ++first;
  std::vector<Real> p(control.begin() + static_cast<std::ptrdiff_t>(first),
                      control.begin() + static_cast<std::ptrdiff_t>(first + degree + 1));
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t i = 0; i + r <= degree; ++i) {
      const Real lower = knots[first + i + r - 1], upper = knots[first + i + degree];
      p[i] = ((upper - t) * p[i] + (t - lower) * p[i + 1]) / (upper - lower);
    }
  return p[0];
}

/// The slope is the spline of one degree less whose controls are the differences.
Signs from_curvature(const IntrinsicForm& form, Real t) {
  const std::vector<Real> k(form.control_curvatures.begin(), form.control_curvatures.end());
  const auto n = static_cast<std::size_t>(form.degree);
  std::vector<Real> rise;
  for (std::size_t i = 0; i + 1 < k.size(); ++i)
    rise.push_back((k[i + 1] - k[i]) / (static_cast<Real>(form.knots[i + n]) - static_cast<Real>(form.knots[i])));
  const std::span<const double> inner = std::span(form.knots).subspan(1, form.knots.size() - 2);
  return {{spline(k, form.knots, n, t), 1}, {spline(rise, inner, n - 1, t), 1}};
}

Signs from_curvature(const ClothoidForm& form, Real t) {
  const Real rise = static_cast<Real>(form.curvature_rate) * static_cast<Real>(form.length);
  return {{static_cast<Real>(form.curvature) + rise * t, std::abs(rise)}, {rise, std::abs(rise)}};
}

Signs signs_at(const ExactForm& form, Real t) {
  if (const auto* clothoid = std::get_if<ClothoidForm>(&form)) return from_curvature(*clothoid, t);
  if (const auto* intrinsic = std::get_if<IntrinsicForm>(&form)) return from_curvature(*intrinsic, t);
  return from_position(form, t);
}

// Random segments.

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  int one_of(int n) { return std::uniform_int_distribution<int>(0, n - 1)(generator_); }
  Vec2 point() { return {between(-1, 1), between(-1, 1)}; }

 private:
  std::mt19937_64 generator_;
};

SegmentPtr polynomial(Random& random, int degree) {
  std::vector<Vec2> points;
  for (int i = 0; i <= degree; ++i) points.push_back(random.point());
  return std::make_shared<PolynomialSegment>(points);
}

SegmentPtr trigonometric(Random& random) {
  std::array<Vec2, 5> points;
  for (Vec2& p : points) p = random.point();
  return std::make_shared<TrigonometricSegment>(points);
}

SegmentPtr rational(Random& random) {
  RationalForm form;
  const int degree = 2 + random.one_of(4);
  for (int i = 0; i <= degree; ++i) {
    form.control_points.push_back(random.point());
    form.weights.push_back(std::exp(random.between(-2, 2)));
  }
  return std::make_shared<RationalSegment>(std::move(form));
}

SegmentPtr clothoid(Random& random) {
  return std::make_shared<ClothoidSegment>(ClothoidForm{random.point(), random.between(-3, 3), random.between(-5, 5),
                                                        random.between(-9, 9), random.between(0.1, 2)});
}

SegmentPtr circle(Random& random) {
  return std::make_shared<ClothoidSegment>(
      ClothoidForm{random.point(), random.between(-3, 3), random.between(-2, 2), 0.0, random.between(0.1, 2)});
}

SegmentPtr elliptic(Random& random) {
  return std::make_shared<EllipticArcSegment>(
      EllipticArcForm{random.point(), random.point(), random.point(), random.between(-4, 4), random.between(-4, 4)});
}

SegmentPtr intrinsic(Random& random) {
  const int degree = 1 + random.one_of(4), inner = random.one_of(4);
  const auto ends = static_cast<std::size_t>(degree);
  std::vector<double> knots(ends, 0.0);
  for (int i = 0; i < inner; ++i) knots.push_back(random.between(0.01, 0.99));
  std::ranges::sort(knots);
  knots.insert(knots.end(), ends, 1.0);
  std::vector<double> controls;
  for (int i = 0; i <= degree + inner; ++i) controls.push_back(random.between(-2, 2));
  return std::make_shared<IntrinsicSegment>(IntrinsicForm{{0, 0}, 0.0, 1.0, degree, knots, controls});
}

SegmentPtr reparametrized(Random& random) {
  const int kind = random.one_of(3);
  const SegmentPtr of = kind == 0   ? polynomial(random, 2 + random.one_of(4))
                        : kind == 1 ? elliptic(random)
                                    : trigonometric(random);
  return std::make_shared<ReparametrizedSegment>(of, std::exp(random.between(-2, 2)));
}

/// What is blended: also a line, and all at other speeds.
SegmentPtr part(Random& random) {
  const int kind = random.one_of(4);
  const SegmentPtr of = kind == 0   ? polynomial(random, 1 + random.one_of(3))
                        : kind == 1 ? elliptic(random)
                        : kind == 2 ? circle(random)
                                    : polynomial(random, 2);
  if (random.one_of(2) == 0) return of;
  return std::make_shared<ReparametrizedSegment>(of, std::exp(random.between(-1, 1)));
}

SegmentPtr blend(Random& random) { return std::make_shared<BlendSegment>(part(random), part(random)); }

// The comparison.

constexpr int cells = 64;

/// What is compared of many segments.
struct Tally {
  int segments = 0, sampled = 0, changes = 0, close_pairs = 0;
};

/// Holds the sign changes against a function that can be evaluated at will.
class Comparison {
 public:
  Comparison(const SignChanges& changes, std::function<Value(Real)> f)
      : changes_(changes),
        f_(std::move(f)),
        rounding_(changes.certification == Certification::exact ? Real(0x1p-55) : Real(0x1p-40)) {}

  /// What is wrong, empty if every change that is claimed happens, and no other.
  [[nodiscard]] std::string fault(const std::vector<Value>& samples, Tally& tally) const {
    const std::vector<RootBracket>& at = changes_.at;
    double end = 0.0;
    for (const RootBracket& b : at) {
      if (!(end <= b.lo && b.lo <= b.hi && b.hi <= 1.0)) return fmt::format("a bracket [{}, {}]", b.lo, b.hi);
      end = b.hi;
    }
    // The function's sign, where a sample tells it, times the sign that the changes before it give: always the same.
    int first = 0, before = 0;
    for (int i = 0; i < cells; ++i) {
      const Real t = place(i);
      const int here = changes_before(t), sign = sign_of(samples[static_cast<std::size_t>(i)]);
      if (i > 0 && here - before > 1) tally.close_pairs += (here - before) / 2;
      before = here;
      if (sign == 0 || inside_bracket(t)) continue;
      const int turned = here % 2 == 0 ? sign : -sign;
      if (first == 0) first = turned;
      if (turned != first) return fmt::format("a change before {} is missing or invented", static_cast<double>(t));
    }
    for (std::size_t i = 0; i < at.size(); ++i)
      if (!changes_sign(i)) return fmt::format("no change at {}", at[i].mid());
    for (int i = 1; i + 1 < cells; ++i)
      if (missed_pair(samples, i)) return fmt::format("a pair of changes near {}", static_cast<double>(place(i)));
    tally.changes += static_cast<int>(at.size());
    return {};
  }

  static Real place(int i) { return (static_cast<Real>(i) + Real(0.5)) / cells; }

 private:
  [[nodiscard]] int sign_of(const Value& v) const {
    return std::abs(v.value) <= rounding_ * v.terms ? 0 : v.value > 0 ? 1 : -1;
  }
  [[nodiscard]] int sign_at(Real t) const { return sign_of(f_(t)); }
  [[nodiscard]] int changes_before(Real t) const {
    return static_cast<int>(
        std::ranges::count_if(changes_.at, [t](const RootBracket& b) { return static_cast<Real>(b.mid()) < t; }));
  }
  [[nodiscard]] bool inside_bracket(Real t) const {
    return std::ranges::any_of(changes_.at, [t](const RootBracket& b) { return b.lo <= t && t <= b.hi; });
  }

  /// Signs certain on both sides of bracket i, before the next bracket, are opposite. That they are nowhere certain is
  /// only believed where the sides are narrower than the rounding of parameters blown up.
  [[nodiscard]] bool changes_sign(std::size_t i) const {
    const std::vector<RootBracket>& at = changes_.at;
    const Real lo = at[i].lo, hi = at[i].hi;
    const Real left = i > 0 ? Real(at[i - 1].hi) : 0, right = i + 1 < at.size() ? Real(at[i + 1].lo) : 1;
    int before = 0, after = 0;
    for (Real part = Real(0x1p-50); part < 1 && before == 0; part *= 2) before = sign_at(lo - part * (lo - left));
    for (Real part = Real(0x1p-50); part < 1 && after == 0; part *= 2) after = sign_at(hi + part * (right - hi));
    if (before == 0 || after == 0) return std::min(lo - left, right - hi) < Real(1e-6);
    return before == -after;
  }

  /// A sample that is nearer to zero than both neighbours, while the parabola through the three comes nearer by half:
  /// golden section for the least |f| between these finds another sign where no change is claimed.
  [[nodiscard]] bool missed_pair(const std::vector<Value>& samples, int i) const {
    const auto k = static_cast<std::size_t>(i);
    const int sign = sign_of(samples[k]);
    if (sign == 0 || sign != sign_of(samples[k - 1]) || sign != sign_of(samples[k + 1])) return false;
    const auto size = [&](std::size_t at) { return std::abs(samples[at].value); };
    const Real fall = size(k - 1) - size(k), rise = size(k + 1) - size(k);
    if (fall < 0 || rise < 0) return false;
    if ((rise - fall) * (rise - fall) <= 4 * (rise + fall) * size(k)) return false;
    if (changes_before(place(i - 1)) != changes_before(place(i + 1))) return false;  // a pair, and it is known
    Real a = place(i - 1), b = place(i + 1);
    const Real golden = (std::sqrt(Real(5)) - 1) / 2;
    for (int step = 0; step < 40; ++step) {
      const Real x = b - golden * (b - a), y = a + golden * (b - a);
      const Value fx = f_(x), fy = f_(y);
      if (sign_of(fx) == -sign || sign_of(fy) == -sign) return true;
      (sign * fx.value < sign * fy.value ? b : a) = sign * fx.value < sign * fy.value ? y : x;
    }
    return false;
  }

  const SignChanges& changes_;
  std::function<Value(Real)> f_;
  Real rounding_;
};

std::string compare(const Segment& segment, bool of_slope, const std::vector<Signs>& signs, Tally& tally) {
  const SignChanges changes = of_slope ? curvature_extrema(segment) : inflections(segment);
  ++tally.segments;
  if (changes.certification == Certification::sampled) {
    ++tally.sampled;
    return {};
  }
  if (changes.vanishes) return {};
  const ExactForm form = segment.exact();
  std::vector<Value> samples;
  for (const Signs& s : signs) samples.push_back(of_slope ? s.slope : s.curvature);
  const auto f = [&](Real t) {
    const Signs s = signs_at(form, t);
    return of_slope ? s.slope : s.curvature;
  };
  return Comparison(changes, f).fault(samples, tally);
}

/// Many random segments of one kind; returns what was compared.
Tally compare_many(const char* kind, const std::function<SegmentPtr(Random&)>& make) {
  Random random(13);
  Tally tally;
  for (int i = 0; i < test::cases(10000); ++i) {
    const SegmentPtr segment = make(random);
    const ExactForm form = segment->exact();
    std::vector<Signs> signs;
    for (int k = 0; k < cells; ++k) signs.push_back(signs_at(form, Comparison::place(k)));
    for (const bool of_slope : {true, false}) {
      const std::string fault = compare(*segment, of_slope, signs, tally);
      if (!fault.empty()) FAIL_CHECK(kind << ' ' << i << (of_slope ? ", extrema: " : ", inflections: ") << fault);
    }
  }
  UNSCOPED_INFO(kind << ": " << tally.changes << " changes, " << tally.close_pairs << " pairs closer than samples, "
                     << tally.sampled << " sampled");
  return tally;
}

}  // namespace

// Where nothing is wrong, changes that sampling cannot see (two between neighbouring samples) are the only difference:
// they are verified one by one.

TEST_CASE("polynomials: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("polynomial", [](Random& r) { return polynomial(r, 2 + r.one_of(4)); });
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 2);
}

TEST_CASE("trigonometric segments: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("trigonometric", trigonometric);
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 2);
}

TEST_CASE("rational segments: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("rational", rational);
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 2);
}

TEST_CASE("clothoids: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("clothoid", clothoid);
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 10);
}

TEST_CASE("curvature splines: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("intrinsic", intrinsic);
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 2);
}

TEST_CASE("elliptical arcs: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("elliptic", elliptic);
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 2);
}

TEST_CASE("reparametrised segments: certified changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("reparametrised", reparametrized);
  CHECK(tally.sampled == 0);
  CHECK(tally.changes > tally.segments / 2);
}

TEST_CASE("blends: enclosed changes are those of dense samples", "[roots][curvature]") {
  const Tally tally = compare_many("blend", blend);
  CHECK(tally.sampled <= tally.segments / 1000);
  CHECK(tally.changes > tally.segments / 2);
}
