#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "schemes/clothoid3/hermite.hpp"
#include "schemes/segments/clothoid.hpp"
#include "schemes/segments/g1_clothoid.hpp"

namespace kappabench::clothoid3 {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// The end of a clothoid that starts at the origin, and its derivatives by the curvature and its rate.
struct Displacement {
  Complex end, by_curvature, by_rate;
};

Displacement displacement(double heading, double curvature, double rate, double length) {
  const auto m = clothoid_moments(heading, curvature * length, rate * length * length);
  const Complex i(0.0, 1.0);
  return {length * m[0], i * (length * length) * m[1], i * (0.5 * length * length * length) * m[2]};
}

/// The problem in a frame where the points are (-1, 0) and (1, 0).
struct Problem {
  double heading0, curvature0, heading1, curvature1;
  double length0, length1;  ///< of the outer arcs
};

/// The unknowns: half the length of the middle arc and the heading at its middle.
struct Unknowns {
  double half, heading;
};

/// Everything that follows from the unknowns.
struct State {
  double rate0, rate1;          ///< of curvature, outer arcs
  double curvature, rate;       ///< of the middle arc, at its middle
  Complex gap;                  ///< end of the arcs - (2, 0)
  Complex by_half, by_heading;  ///< derivatives of the gap

  [[nodiscard]] double residual() const { return std::abs(gap); }
};

/// G2 at both joints is linear in the curvature K and rate R at the middle and the two outer rates. With
/// alpha_j = h + s_j / 2, beta_j = h (h + s_j) / 2, h the half length, s_j those of the outer arcs:
///   -alpha_0 K + beta_0 R = A = theta_0 + k_0 s_0 / 2 - theta,
///    alpha_1 K + beta_1 R = B = theta_1 - k_1 s_1 / 2 - theta.
State state_of(const Problem& p, const Unknowns& x) {
  const double h = x.half, s0 = p.length0, s1 = p.length1;
  const double alpha0 = h + 0.5 * s0, alpha1 = h + 0.5 * s1;
  const double beta0 = 0.5 * h * (h + s0), beta1 = 0.5 * h * (h + s1);
  const double A = p.heading0 + 0.5 * p.curvature0 * s0 - x.heading;
  const double B = p.heading1 - 0.5 * p.curvature1 * s1 - x.heading;
  const double D = alpha0 * beta1 + alpha1 * beta0;
  const double K = (B * beta0 - A * beta1) / D, R = (A * alpha1 + B * alpha0) / D;
  const double R0 = (K - R * h - p.curvature0) / s0, R1 = (p.curvature1 - K - R * h) / s1;

  // Derivatives; d alpha_j / dh = 1, d beta_j / dh = alpha_j, dA / dtheta = dB / dtheta = -1.
  const double D_h = 2.0 * alpha0 * alpha1 + beta0 + beta1;
  const double K_h = (B * alpha0 - A * alpha1 - K * D_h) / D, R_h = (A + B - R * D_h) / D;
  const double K_t = (beta1 - beta0) / D, R_t = -(alpha0 + alpha1) / D;
  const double R0_h = (K_h - R_h * h - R) / s0, R1_h = (-K_h - R_h * h - R) / s1;
  const double R0_t = (K_t - R_t * h) / s0, R1_t = (-K_t - R_t * h) / s1;

  const Displacement first = displacement(p.heading0, p.curvature0, R0, s0);
  const Displacement last = displacement(p.heading1, p.curvature1, R1, -s1);  // backwards from the end
  const Displacement after = displacement(x.heading, K, R, h), before = displacement(x.heading, K, R, -h);
  const Complex end_after = std::polar(1.0, x.heading + K * h + 0.5 * R * h * h);
  const Complex end_before = std::polar(1.0, x.heading - K * h + 0.5 * R * h * h);

  const Complex by_K = after.by_curvature - before.by_curvature, by_R = after.by_rate - before.by_rate;
  const Complex turned = Complex(0.0, 1.0) * (after.end - before.end);
  return {.rate0 = R0,
          .rate1 = R1,
          .curvature = K,
          .rate = R,
          .gap = first.end + after.end - before.end - last.end - 2.0,
          .by_half = first.by_rate * R0_h + end_after + end_before + by_K * K_h + by_R * R_h - last.by_rate * R1_h,
          .by_heading = first.by_rate * R0_t + turned + by_K * K_t + by_R * R_t - last.by_rate * R1_t};
}

/// The length of an outer arc, at most `third`: it may change its curvature by as much as turns pi / 8, and turn by pi
/// (Bertolazzi and Frego 2018, the bounds of their implementation).
double outer_length(double third, double given, double of_g1, double rate) {
  double length = third;
  const double change = 0.5 * std::abs(given - of_g1) / (pi / 8.0);
  if (change * length > 1.0) length = 1.0 / change;
  const double turn = (std::abs(given + of_g1) + length * std::abs(rate)) / (2.0 * pi);
  if (turn * length > 1.0) length = 1.0 / turn;
  return length;
}

struct Solution {
  Unknowns unknowns;
  State state;
  int iterations;
};

Solution newton(const Problem& problem, Unknowns x) {
  State at = state_of(problem, x);
  int iterations = 0;
  for (; iterations < 50 && at.residual() > 1e-15; ++iterations) {
    const double determinant = (std::conj(at.by_half) * at.by_heading).imag();
    const double d_half = -(std::conj(at.gap) * at.by_heading).imag() / determinant;
    const double d_heading = -(std::conj(at.by_half) * at.gap).imag() / determinant;
    if (!std::isfinite(d_half) || !std::isfinite(d_heading)) break;
    bool better = false;
    for (double step = 1.0; step > 1e-4 && !better; step *= 0.5) {
      const Unknowns trial{x.half + step * d_half, x.heading + step * d_heading};
      if (!(trial.half > 0.0) || trial.half > 1e3) continue;
      const State next = state_of(problem, trial);
      if (!(next.residual() < at.residual())) continue;
      x = trial;
      at = next;
      better = true;
    }
    if (!better) break;  // rounding, or stuck
  }
  return {x, at, iterations};
}

/// The arcs of a solution, from the frame back to the plane. Outer arcs are laid out from the points, so that the gap
/// falls to the end of the middle one.
std::array<ClothoidForm, 3> placed(const Problem& p, const Solution& solution, const CurveElement& from,
                                   const CurveElement& to, double direction, double unit) {
  const auto& [x, s, iterations] = solution;
  const double k = 1.0 / unit, r = k / unit;
  ClothoidForm first{from.point, direction + p.heading0, k * p.curvature0, r * s.rate0, unit * p.length0};
  ClothoidForm middle{
      from.point + clothoid_displacement(first.angle, first.curvature, first.curvature_rate, first.length),
      direction + x.heading - s.curvature * x.half + 0.5 * s.rate * x.half * x.half,
      k * (s.curvature - s.rate * x.half), r * s.rate, unit * 2.0 * x.half};
  const double heading1 = direction + p.heading1, curvature1 = k * p.curvature1, length1 = unit * p.length1;
  ClothoidForm last{to.point + clothoid_displacement(heading1, curvature1, r * s.rate1, -length1),
                    heading1 - curvature1 * length1 + 0.5 * r * s.rate1 * length1 * length1,
                    curvature1 - r * s.rate1 * length1, r * s.rate1, length1};
  return {first, middle, last};
}

}  // namespace

std::optional<ThreeArcs> three_arcs(const CurveElement& from, const CurveElement& to) {
  const auto guess = g1_clothoid(from.point, from.heading, to.point, to.heading);
  if (!guess) return std::nullopt;
  const Vec2 chord = to.point - from.point;
  const double direction = std::atan2(chord.y(), chord.x()), unit = 0.5 * chord.norm();
  Problem problem{.heading0 = std::remainder(from.heading - direction, 2.0 * pi),
                  .curvature0 = from.curvature * unit,
                  .heading1 = std::remainder(to.heading - direction, 2.0 * pi),
                  .curvature1 = to.curvature * unit,
                  .length0 = 0.0,
                  .length1 = 0.0};
  const double length = guess->length / unit, rate = guess->curvature_rate * unit * unit;
  const double k0 = guess->curvature * unit, k1 = k0 + rate * length;
  const double spread = std::abs(problem.heading0 - problem.heading1) / (2.0 * pi);
  const double shrink = std::pow(std::cos(0.5 * pi * std::pow(spread, 4)), 3);

  problem.length0 = shrink * outer_length(length / 3.0, problem.curvature0, k0, rate);
  problem.length1 = shrink * outer_length(length / 3.0, problem.curvature1, k1, rate);

  const double half = 0.5 * (length - problem.length0 - problem.length1), middle = problem.length0 + half;
  const Solution solution = newton(problem, {half, problem.heading0 + (k0 + 0.5 * rate * middle) * middle});
  if (!(solution.state.residual() <= 1e-10)) return std::nullopt;
  const ThreeArcs found{placed(problem, solution, from, to, direction, unit), solution.iterations,
                        solution.state.residual()};
  // Rates grow with the square of curvatures, which may be too large for that.
  if (!std::ranges::all_of(found.arcs, [](const ClothoidForm& arc) { return std::isfinite(arc.curvature_rate); }))
    return std::nullopt;
  return found;
}

}  // namespace kappabench::clothoid3
