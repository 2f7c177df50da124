#include "schemes/intrinsic/monotone_family.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "schemes/intrinsic/fixed_knots.hpp"
#include "schemes/intrinsic/viable_region.hpp"
#include "schemes/numerics/damped_newton.hpp"
#include "schemes/numerics/gauss.hpp"
#include "schemes/numerics/logistic.hpp"

namespace kappabench::intrinsic {

namespace {

constexpr int degree = 3;
constexpr std::size_t controls = 8;
constexpr std::size_t knots = 10;
constexpr std::size_t spans = 5;

/// Value and derivatives by log_length, y, z.
using Dual = ceres::Jet<double, 3>;

/// A number in [0, 1] and what it lacks to 1, each with full relative precision.
template <class T>
struct Share {
  T of;
  T rest;
};

template <class T>
struct Shape {
  std::array<Share<T>, knots> knot;
  std::array<T, spans> width;    ///< of the knot spans
  std::array<T, controls> rise;  ///< C_i, from 0 to 1
};

template <class T>
Shape<T> shape_of(const T& y, const T& z) {
  using std::log, std::sqrt, std::expm1;
  const T a = std::log(2.0) / softplus(T(-y));
  const T aa = a * a;
  const T r = sqrt(1.0 + aa);
  const T b = z * r, zeta = z * a / r;
  const T o1 = std::log(1.5) / a, o2 = o1 + 2.0 * std::log(8.0 / 3.0) / (1.0 + a);
  const std::array<T, 4> offset{-o2, -o1, o1, o2};

  Shape<T> shape;
  const Share<T> zero{T(0.0), T(1.0)}, one{T(1.0), T(0.0)};
  shape.knot = {zero, zero, zero, zero, zero, zero, zero, one, one, one};
  for (std::size_t i = 0; i < offset.size(); ++i) {
    const T logit = offset[i] - zeta;
    shape.knot[degree + i] = {logistic(logit), logistic(T(-logit))};
  }
  shape.width.front() = shape.knot[degree].of;
  shape.width.back() = shape.knot[degree + 3].rest;
  // sigma(q) - sigma(p) = sigma(q) sigma(-p) (1 - exp(p - q)): knots that nearly meet keep their distance.
  for (std::size_t i = 0; i + 1 < offset.size(); ++i)
    shape.width[i + 1] =
        -shape.knot[degree + i + 1].of * shape.knot[degree + i].rest * expm1(T(offset[i] - offset[i + 1]));

  const T a4 = aa * aa;
  const T root = 2.0 * a / (1.0 + aa);
  const T w = root * root;
  const T step_weight = (1.0 - w) * a4 / (1.0 + a4), plateau_weight = (1.0 - w) / (1.0 + a4);
  const T c = logistic(z);
  const std::array<T, controls> plateau{T(0.0), 0.5 * c, c, c, c, c, 0.5 * (1.0 + c), T(1.0)};
  shape.rise.front() = T(0.0);
  shape.rise.back() = T(1.0);
  for (std::size_t i = 1; i + 1 < controls; ++i) {
    T of = T(0.0), rest = T(0.0);
    for (std::size_t k = i; k < i + degree; ++k) {
      of += shape.knot[k].of;
      rest += shape.knot[k].rest;
    }
    const T sigmoid = logistic(T(a * log(of / rest) + b));
    shape.rise[i] = w * sigmoid + plateau_weight * plateau[i];
    if (i >= controls / 2) shape.rise[i] += step_weight;
  }
  return shape;
}

/// Bernstein coefficients of the spans, spans * degree + 1 of them, neighbours sharing their common one: Boehm's knot
/// insertion for a cubic. It needs the widths of spans alone, so that spans far narrower than 1 lose nothing.
template <class T>
std::array<T, spans * degree + 1> bernstein_of(const Shape<T>& shape) {
  const auto width = [&](std::size_t j) { return j < spans ? shape.width[j] : T(0.0); };  // none outside [0, 1]
  std::array<T, spans * degree + 1> b;
  b.front() = shape.rise.front();
  b.back() = shape.rise.back();
  for (std::size_t j = 0; j < spans; ++j) {
    // Both inner coefficients lie between controls j + 1 and j + 2, whose knots reach from span j - 1 to span j + 1.
    const T before = width(j - 1), up_to = before + width(j);
    const T slope = (shape.rise[j + 2] - shape.rise[j + 1]) / (up_to + width(j + 1));
    b[3 * j + 1] = shape.rise[j + 1] + before * slope;
    b[3 * j + 2] = shape.rise[j + 1] + up_to * slope;
    if (j > 0) b[3 * j] = b[3 * j - 1] + (b[3 * j + 1] - b[3 * j - 1]) * (before / up_to);
  }
  return b;
}

template <class T>
struct Direction {
  T sine;
  T cosine;
};

/// Sine and cosine once for value and derivatives: this is where the time goes.
void add_direction(double weight, const Dual& angle, Direction<Dual>& sum) {
  const double s = weight * std::sin(angle.a), c = weight * std::cos(angle.a);
  sum.sine.a += s;
  sum.cosine.a += c;
  sum.sine.v += c * angle.v;
  sum.cosine.v -= s * angle.v;
}

/// Turning, and the end against the chord's.
template <class T>
std::array<T, 3> equations_of(const T& log_length, const Shape<T>& shape, const StandardData& data) {
  using std::exp;
  const double start = data.start_curvature.value(), range = data.end_curvature.value() - start;
  const T length = exp(log_length);
  T across = T(0.0), along = T(0.0);
  T angle = T(-data.chord_angle);
  const std::array<T, spans* degree + 1> rise = bernstein_of(shape);
  for (std::size_t j = 0; j < spans; ++j) {
    // Bernstein coefficients of the angle on the span: running sums of those of the curvature.
    std::array<T, degree + 2> theta;
    theta[0] = angle;
    const T share = length * shape.width[j] / (degree + 1.0);
    for (std::size_t i = 0; i <= degree; ++i) theta[i + 1] = theta[i] + share * (start + range * rise[degree * j + i]);
    angle = theta[degree + 1];
    Direction<T> sum{T(0.0), T(0.0)};
    const auto add = [&](double v, double weight) {
      const double u = 1.0 - v, uu = u * u, vv = v * v;
      add_direction(weight,
                    T((uu * uu) * theta[0] + (4.0 * uu * u * v) * theta[1] + (6.0 * uu * vv) * theta[2] +
                      (4.0 * u * vv * v) * theta[3] + (vv * vv) * theta[4]),
                    sum);
    };
    double turning = 0.0;
    for (std::size_t i = 0; i <= degree; ++i) turning += std::abs(theta[i + 1].a - theta[i].a);
    const int panels = 1 + static_cast<int>(std::min(0.4 * turning, 1e3));
    for_composite_gauss_nodes<16>(panels, add);
    across += shape.width[j] * sum.sine;
    along += shape.width[j] * sum.cosine;
  }
  return {angle - data.end_angle(), length * across, length * along - 1.0};
}

/// Where data of fixed angles are in the viable region: the border is at nesting = -infinity.
struct Place {
  double nesting;  ///< log(xi - 1)
  double balance;  ///< log(X / Y)
};

Place place_of(const StandardData& data) {
  const Viability v = viability(data);
  return {std::log((v.start_slack * v.end_slack - v.least_product) / v.least_product),
          std::log(v.start_slack / v.end_slack)};
}

StandardData at_place(StandardData data, const Place& place) {
  const Viability v = viability(data);
  const double slack = std::sqrt(v.least_product * (1.0 + std::exp(place.nesting)));
  data.start_curvature = 2.0 * std::sin(data.chord_angle) - slack * std::exp(0.5 * place.balance);
  data.end_curvature = 2.0 * std::sin(data.end_angle()) + slack * std::exp(-0.5 * place.balance);
  return data;
}

/// The continuation for one set of data: rising curvature, the larger end first.
class Continuation {
 public:
  explicit Continuation(const StandardData& data)
      : data_(data),
        exact_(std::max(2e-14, 4e-16 * std::max(std::abs(*data.start_curvature), std::abs(*data.end_curvature)))),
        room_(std::sqrt(viability(data).least_product)) {
    const Solved clothoid = g1_clothoid(data);
    StandardData from = data;
    from.start_curvature = clothoid.x;
    from.end_curvature = clothoid.y;
    begin_ = place_of(from);
    clothoid_ = {std::log(clothoid.length), 0.0, 0.0};
  }

  /// The data's member, with the problems on the way solved to `share` of what the family can differ by at all, which
  /// is as small as the difference of the end angles.
  [[nodiscard]] NewtonResult run(double share) const {
    const double on_the_way = std::max(exact_, share * room_);
    const Place goal = place_of(data_);
    NewtonResult result = along(clothoid_, begin_, goal, true, on_the_way);
    // Stuck: round the corner, one coordinate after the other.
    for (const Place& corner : {Place{begin_.nesting, goal.balance}, Place{goal.nesting, begin_.balance}}) {
      if (result.converged) break;
      NewtonResult half = along(clothoid_, begin_, corner, false, on_the_way);
      half.iterations += result.iterations;
      result = half;
      if (!half.converged) continue;
      result = along(half.x, corner, goal, true, on_the_way);
      result.iterations += half.iterations;
    }
    return result;
  }

 private:
  /// From one place to another one in a straight line; the last step is to the data themselves, if they are there, and
  /// not to what their place rounds to.
  [[nodiscard]] NewtonResult along(const Eigen::Vector3d& x, const Place& begin, const Place& end, bool to_data,
                                   double on_the_way) const {
    const double way = std::max(std::abs(end.nesting - begin.nesting), std::abs(end.balance - begin.balance));
    const auto solve_at = [&](double s, const Eigen::Vector3d& guess) {
      const Place place{begin.nesting + s * (end.nesting - begin.nesting),
                        begin.balance + s * (end.balance - begin.balance)};
      const bool arrived = to_data && s == 1.0;
      const StandardData goal = arrived ? data_ : at_place(data_, place);
      const auto equations = [&](const Eigen::Vector3d& u) { return member_equations({u[0], u[1], u[2]}, goal); };
      return damped_newton(equations, guess, {0.7, 1.5, 1.5}, arrived ? exact_ : on_the_way, 8);
    };
    return follow_solution(solve_at, x, std::min(1.0, 3.0 / std::max(way, 1e-300)), 1e-4);
  }

  StandardData data_;
  double exact_;  ///< residual that rounding allows
  double room_;
  Place begin_;  ///< of the clothoid
  Eigen::Vector3d clothoid_;
};

MonotoneSolution solve_rising(const StandardData& data) {
  const Continuation continuation(data);
  NewtonResult result = continuation.run(1e-5);
  if (!result.converged) {
    const int spent = result.iterations;
    result = continuation.run(0.0);
    result.iterations += spent;
  }
  const FamilyMember member{result.x[0], result.x[1], result.x[2]};
  return {member_curve(member, *data.start_curvature, *data.end_curvature), result.iterations, result.residual,
          result.converged};
}

}  // namespace

StandardCurve member_curve(const FamilyMember& member, double start, double end) {
  const Shape<double> shape = shape_of(member.y, member.z);
  StandardCurve curve{{degree, {}}, {}, std::exp(member.log_length)};
  for (const Share<double>& knot : shape.knot) curve.basis.knots.push_back(knot.of);
  // Plateaus are flat up to rounding; monotone controls prove the curvature monotone.
  double risen = 0.0;
  for (const double rise : shape.rise)
    curve.controls.push_back(start + (end - start) * (risen = std::max(risen, rise)));
  curve.controls.back() = end;
  return curve;
}

ThreeEquations member_equations(const FamilyMember& member, const StandardData& data) {
  const Dual log_length(member.log_length, 0), y(member.y, 1), z(member.z, 2);
  const std::array<Dual, 3> e = equations_of(log_length, shape_of(y, z), data);
  ThreeEquations equations;
  for (int i = 0; i < 3; ++i) {
    equations.value[i] = e[static_cast<std::size_t>(i)].a;
    equations.jacobian.row(i) = e[static_cast<std::size_t>(i)].v.transpose();
  }
  return equations;
}

namespace {

/// Steps so narrow that their knots meet in rounded numbers, or run into the ends: kept apart by the last place.
MonotoneSolution with_distinct_knots(MonotoneSolution solution) {
  constexpr double least = 1e-300, most = 1.0 - 0x1p-53;
  std::vector<double>& t = solution.curve.basis.knots;
  for (std::size_t i = degree; i < degree + 4; ++i) t[i] = std::clamp(t[i], least, most);
  if (t[degree] == t[degree + 3]) t[degree] = std::nextafter(t[degree], 0.0);
  return solution;
}

}  // namespace

MonotoneSolution solve_monotone(const StandardData& data) {
  if (data.turning < 2.0 * data.chord_angle) {
    MonotoneSolution solution = solve_monotone(mirrored(data));
    solution.curve = mirrored(std::move(solution.curve));
    return solution;
  }
  if (std::abs(data.end_curvature.value()) > std::abs(data.start_curvature.value())) {
    MonotoneSolution solution = solve_rising(reversed(data));
    solution.curve = reversed(std::move(solution.curve));
    return with_distinct_knots(std::move(solution));
  }
  return with_distinct_knots(solve_rising(data));
}

}  // namespace kappabench::intrinsic
