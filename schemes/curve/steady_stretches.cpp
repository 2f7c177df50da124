#include "schemes/curve/steady_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "schemes/curve/hodograph_forms.hpp"

namespace kappabench {
namespace {

constexpr double widest = 0.5;  // radius of the disc over the distance of its centre from 0
constexpr int deepest = 48;
constexpr int first_parts = 4;  // of a segment whose velocity is only estimated

/// Bernstein control vectors of a positive multiple of the velocity.
using Velocity = std::vector<Vec2>;

Velocity control_vectors(const HodographForms<double>& forms) {
  Velocity velocity;
  const auto degree = static_cast<double>(forms.x.size()) - 1.0;
  double binomial = 1.0;
  for (std::size_t i = 0; i < forms.x.size(); ++i) {
    velocity.emplace_back(forms.x[i] / binomial, forms.y[i] / binomial);
    binomial *= (degree - static_cast<double>(i)) / (static_cast<double>(i) + 1.0);
  }
  return velocity;
}

/// The forms at the drawing's scale could overflow in products, those of a first difference cannot.
template <class Points>
Velocity velocity_of(const Points& points, bool trigonometric) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Vec2& p : points) {
    x.push_back(p.x());
    y.push_back(p.y());
  }
  return control_vectors(trigonometric ? trigonometric_hodograph<double>(x, y) : polynomial_hodograph<double>(x, y));
}

bool steady(const Velocity& velocity) {
  Vec2 least = velocity.front();
  Vec2 most = velocity.front();
  for (const Vec2& v : velocity) {
    least = least.cwiseMin(v);
    most = most.cwiseMax(v);
  }
  const Vec2 centre = 0.5 * (least + most);
  const double radius = widest * centre.norm();
  return std::ranges::all_of(velocity, [&](const Vec2& v) { return (v - centre).norm() <= radius; });
}

/// De Casteljau's algorithm in the middle.
std::pair<Velocity, Velocity> halves_of(const Velocity& velocity) {
  Velocity left;
  Velocity right = velocity;
  for (std::size_t last = velocity.size(); last > 0; --last) {
    left.push_back(right.front());
    for (std::size_t i = 0; i + 1 < last; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  return {std::move(left), std::move(right)};
}

/// Appends the ends of the stretches of [x0, x1]. `rounding` is the error of control vectors: below it none is known.
void append_stretches(const Velocity& velocity, double x0, double x1, double rounding, int depth,
                      std::vector<double>& ends) {
  const bool lost = std::ranges::all_of(velocity, [rounding](const Vec2& v) { return !(v.norm() > rounding); });
  if (depth == deepest || lost || steady(velocity)) {
    ends.push_back(x1);
    return;
  }
  const auto [left, right] = halves_of(velocity);
  const double middle = 0.5 * (x0 + x1);
  append_stretches(left, x0, middle, rounding, depth + 1, ends);
  append_stretches(right, middle, x1, rounding, depth + 1, ends);
}

std::vector<double> stretches_of(const Velocity& velocity) {
  double largest = 0.0;
  for (const Vec2& v : velocity) largest = std::max(largest, v.norm());
  std::vector<double> ends{0.0};
  append_stretches(velocity, 0.0, 1.0, 0x1p-52 * largest, 0, ends);
  return ends;
}

void append_estimated(const Segment& segment, double t0, double t1, int depth, std::vector<double>& ends) {
  const double middle = 0.5 * (t0 + t1);
  const double half = 0.5 * (t1 - t0);
  const Jet jet = segment.jet(middle, 4);
  const double radius =
      half * (jet.d[2].norm() + half / 2.0 * (jet.d[3].norm() + half / 3.0 * jet.d[4].norm()));  // Taylor's polynomial
  if (depth == deepest || !std::isfinite(radius) || radius <= widest * speed(jet) || radius == 0.0) {
    ends.push_back(t1);
    return;
  }
  append_estimated(segment, t0, middle, depth + 1, ends);
  append_estimated(segment, middle, t1, depth + 1, ends);
}

std::vector<double> estimated_stretches(const Segment& segment) {
  std::vector<double> ends{0.0};
  for (int k = 0; k < first_parts; ++k) {
    append_estimated(segment, static_cast<double>(k) / first_parts, (k + 1.0) / first_parts, 2, ends);
  }
  return ends;
}

std::vector<double> knots_of(const IntrinsicForm& form) {
  std::vector<double> knots{0.0};
  for (const double knot : form.knots)
    if (knot > knots.back() && knot < 1.0) knots.push_back(knot);
  knots.push_back(1.0);
  return knots;
}

}  // namespace

std::vector<double> steady_stretches(const Segment& segment) {
  const ExactForm form = segment.exact();
  if (const auto* polynomial = std::get_if<PolynomialForm>(&form))
    return stretches_of(velocity_of(polynomial->control_points, false));
  if (const auto* trigonometric = std::get_if<TrigonometricForm>(&form)) {
    // Over x = tan(pi t / 4), where the segment is rational.
    std::vector<double> ends = stretches_of(velocity_of(trigonometric->control_points, true));
    for (double& end : ends) end = 4.0 * std::numbers::inv_pi * std::atan(end);
    ends.back() = 1.0;
    return ends;
  }
  if (std::holds_alternative<ClothoidForm>(form)) return {0.0, 1.0};
  if (const auto* intrinsic = std::get_if<IntrinsicForm>(&form)) return knots_of(*intrinsic);
  return estimated_stretches(segment);
}

bool has_constant_speed(const Segment& segment) {
  const ExactForm form = segment.exact();
  return std::holds_alternative<ClothoidForm>(form) || std::holds_alternative<IntrinsicForm>(form);
}

}  // namespace kappabench
