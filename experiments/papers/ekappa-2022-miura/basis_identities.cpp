#include "experiments/papers/ekappa-2022-miura/basis_identities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "datasets/random_source.hpp"
#include "experiments/papers/ekappa-2022-miura/applicability_bases.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"

namespace kappabench::miura {

namespace {

using std::numbers::pi;

constexpr int grid = 200;
constexpr int trials = 200;

/// u, v, w of Eq. (14), as printed.
struct Linear {
  explicit Linear(double t) : s(std::sin(pi * t / 2.0)), c(std::cos(pi * t / 2.0)) {}
  double s, c;
  double u = 1.0 - s, v = s + c - 1.0, w = 1.0 - c;
};

double over_grid(const std::function<double(const Linear&)>& deviation) {
  double worst = 0.0;
  for (int k = 0; k <= grid; ++k) worst = std::max(worst, deviation(Linear(static_cast<double>(k) / grid)));
  return worst;
}

Vec2 random_point(RandomSource& random) {
  const double x = random.uniform(-1.0, 1.0);
  return {x, random.uniform(-1.0, 1.0)};
}

std::array<Vec2, 3> random_triangle(RandomSource& random) {
  return {random_point(random), random_point(random), random_point(random)};
}

/// Distance of a segment from the same curve in another form, over random triangles and all shape parameters.
template <class Segment, std::size_t count>
double segment_deviation(const char* basis_id, double least,
                         const std::function<std::array<Vec2, count>(const std::array<Vec2, 3>&, double)>& control) {
  const DegenerateBasis& basis = basis_named(basis_id);
  const double per_a = std::string_view(basis_id) == "cubic-alternative" ? 3.0 : 1.0;
  RandomSource random(17);
  double worst = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const double a = random.uniform(least, 1.0), t = random.uniform(0.0, 1.0);
    const auto q = random_triangle(random);
    const auto points = control(q, a);
    const Jet ours = Segment(points).jet(t, 0), theirs = degenerate_curve(basis, per_a * a, q, t);
    worst = std::max(worst, (ours.position() - theirs.position()).norm());
  }
  return worst;
}

/// Eq. (17) as a segment against Eq. (29).
double built_in_deviation() {
  return segment_deviation<TrigonometricSegment, 5>("trigonometric", 0.5, [](const std::array<Vec2, 3>& q, double a) {
    const double b = 1.0 - a;
    return std::array<Vec2, 5>{q[0], b * q[0] + a * q[1], 0.5 * (b * q[0] + 2.0 * a * q[1] + b * q[2]),
                               a * q[1] + b * q[2], q[2]};
  });
}

/// Appendix C.2 against Eq. (1).
double alternative_deviation() {
  return segment_deviation<PolynomialSegment, 4>(
      "cubic-alternative", 2.0 / 3.0, [](const std::array<Vec2, 3>& q, double a) {
        return std::array<Vec2, 4>{q[0], (1.0 - a) * q[0] + a * q[1], a * q[1] + (1.0 - a) * q[2], q[2]};
      });
}

/// Sum of coefficient, function and point over the basis of degree n: even numbers are u^i w^j, odd ones v u^i w^j.
Vec2 by_coefficients(std::span<const double> coefficients, std::span<const Vec2> points, const Linear& f) {
  const auto degree = static_cast<int>(points.size() / 2);
  Vec2 sum(0.0, 0.0);
  for (int k = 0; k <= 2 * degree; ++k) {
    const int odd = k % 2, j = k / 2, i = degree - odd - j;
    const auto at = static_cast<std::size_t>(k);
    sum += coefficients[at] * std::pow(f.u, i) * std::pow(f.w, j) * (odd == 1 ? f.v : 1.0) * points[at];
  }
  return sum;
}

double recursion_deviation() {
  RandomSource random(19);
  const auto triangle = blending_triangle(6);
  double worst = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const int degree = 1 + trial % 6;
    std::vector<Vec2> points(static_cast<std::size_t>(2 * degree + 1));
    for (Vec2& p : points) p = random_point(random);
    const Linear f(random.uniform(0.0, 1.0));
    const Vec2 direct = by_coefficients(triangle[static_cast<std::size_t>(degree - 1)], points, f);
    while (points.size() > 1) {
      for (std::size_t k = 0; k + 2 < points.size(); ++k)
        points[k] = f.u * points[k] + f.v * points[k + 1] + f.w * points[k + 2];
      points.resize(points.size() - 2);
    }
    worst = std::max(worst, (points.front() - direct).norm());
  }
  return worst;
}

double circle_deviation() {
  const Vec2 start(1.0, 0.0), corner(1.0, 1.0), end(0.0, 1.0);
  const TrigonometricSegment segment(std::array<Vec2, 5>{
      start, 0.5 * (start + corner), 0.25 * (start + 2.0 * corner + end), 0.5 * (corner + end), end});
  double worst = 0.0;
  for (int k = 0; k <= grid; ++k) {
    const Jet jet = segment.jet(static_cast<double>(k) / grid, 2);
    worst = std::max({worst, std::abs(jet.position().norm() - 1.0), std::abs(curvature(jet) - 1.0)});
  }
  return worst;
}

/// |f'| of Eq. (21) over its amplitude, at the parameter of Eq. (25): 0 where f is stationary.
double parameter_deviation(bool corrected) {
  RandomSource random(23);
  double worst = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto q = random_triangle(random);
    const Vec2 r = q[1] - q[0], s = q[2] - q[1];
    const double gamma = (s.squaredNorm() - r.squaredNorm()) / r.dot(s);
    const double beta = (-gamma + std::sqrt(gamma * gamma + 4.0)) / 2.0, square = beta * beta + 1.0;
    const Linear f(2.0 / pi * std::asin(1.0 / (corrected ? std::sqrt(square) : square)));
    const double difference = s.squaredNorm() - r.squaredNorm();
    const double slope = f.s * f.c * difference + (f.c * f.c - f.s * f.s) * r.dot(s);
    worst = std::max(worst, std::abs(slope) / std::hypot(0.5 * difference, r.dot(s)));
  }
  return worst;
}

/// Relative difference of the two curvatures of Eq. (26) with the ratio of Eq. (27), for random areas of one sign.
double ratio_deviation(bool corrected) {
  RandomSource random(29);
  double worst = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const double a0 = random.uniform(0.5, 0.95), a1 = random.uniform(0.5, 0.95);
    // Delta_i^+, Delta_{i+1}^-, and those that Eq. (27) prints instead.
    const double plus = random.uniform(0.1, 1.0), minus = random.uniform(0.1, 1.0);
    const double other_plus = random.uniform(0.1, 1.0), other_minus = random.uniform(0.1, 1.0);
    const double first = std::sqrt((1.0 - a0) * (corrected ? plus : other_minus));
    const double second = a0 / a1 * std::sqrt((1.0 - a1) * (corrected ? minus : other_plus));
    const double lambda = first / (first + second);
    const double before = (1.0 - a0) / (a0 * a0) * plus / (lambda * lambda);
    const double after = (1.0 - a1) / (a1 * a1) * minus / ((1.0 - lambda) * (1.0 - lambda));
    worst = std::max(worst, std::abs(before - after) / std::max(before, after));
  }
  return worst;
}

std::string words(std::string_view name) { return std::string(name); }

}  // namespace

std::vector<std::vector<double>> blending_triangle(int most) {
  std::vector<std::vector<double>> rows{{1.0, 1.0, 1.0}};
  while (static_cast<int>(rows.size()) < most) {
    const std::vector<double>& old = rows.back();
    std::vector<double> row(old.size() + 2, 0.0);
    for (std::size_t k = 0; k < old.size(); ++k) {
      row[k] += old[k];                                  // times u
      row[k + 1] += k % 2 == 0 ? old[k] : 2.0 * old[k];  // times v; v^2 = 2uw
      row[k + 2] += old[k];                              // times w
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

const std::vector<Identity>& basis_identities() {
  static const std::vector<Identity> identities{
      {words(names::square), "Eq. (15)",
       [] { return over_grid([](const Linear& f) { return std::abs(f.v * f.v - 2.0 * f.u * f.w); }); }},
      {words(names::unity), "Eq. (16)",
       [] {
         return over_grid([](const Linear& f) {
           return std::abs(f.u * f.u + 2.0 * f.u * f.v + 4.0 * f.u * f.w + 2.0 * f.v * f.w + f.w * f.w - 1.0);
         });
       }},
      {words(names::negative), "Eq. (16)",
       [] {
         return over_grid([](const Linear& f) { return std::max(0.0, -std::min({f.u * f.v, f.u * f.w, f.v * f.w})); });
       }},
      {words(names::built_in), "Eqs. (17), (29)", built_in_deviation},
      {words(names::alternative), "Appendix C.2", alternative_deviation},
      {words(names::recursion), "Eq. (42)", recursion_deviation},
      {words(names::circle), "Sect. 2.2", circle_deviation},
      {words(names::parameter_printed), "Eq. (25)", [] { return parameter_deviation(false); }},
      {words(names::parameter_corrected), "Eq. (25)", [] { return parameter_deviation(true); }},
      {words(names::ratio_printed), "Eq. (27)", [] { return ratio_deviation(false); }},
      {words(names::ratio_corrected), "Eq. (27)", [] { return ratio_deviation(true); }}};
  return identities;
}

}  // namespace kappabench::miura
