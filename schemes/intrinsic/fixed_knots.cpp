#include "schemes/intrinsic/fixed_knots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "schemes/numerics/damped_newton.hpp"

namespace kappabench::intrinsic {

namespace {

constexpr double rounding = 4e-16;
/// Sums of quadratures of curves that turn little end at a few units in the last place.
constexpr double tolerance = 4e-15;
constexpr double ordinary_turning = 2.5, much_turning = 8.0, too_much_turning = 1e3;

}  // namespace

FixedKnots::FixedKnots(const BSplineBasis& basis, ControlRule rule)
    : basis_(basis),
      rule_(std::move(rule)),
      coarse_(angle_table(basis, 1), rule_),
      fine_(angle_table(basis, 2), rule_) {
  const std::vector<double> integrals = basis_integrals(basis);
  integrals_ = Eigen::Map<const Eigen::VectorXd>(integrals.data(), basis.size());
}

Eigen::Vector2d FixedKnots::linearised(const StandardData& data) const {
  // The turning, and the mean angle against the chord: 0 to first order.
  Eigen::Matrix2d m;
  m << coarse_.first_total, coarse_.last_total, coarse_.first_moment, coarse_.last_moment;
  const Eigen::Vector2d want(data.turning - coarse_.fixed_total, data.chord_angle - coarse_.fixed_moment);
  const double det = m.determinant();
  return Eigen::Vector2d(m(1, 1) * want[0] - m(0, 1) * want[1], m(0, 0) * want[1] - m(1, 0) * want[0]) / det;
}

namespace {

/// The linearised x with its first correction: the integral of the sine is that of angle - angle^3 / 6.
double first_guess(const RuleTable& rule, const Eigen::Vector2d& linear, double chord_angle, double ratio) {
  const double x = linear[0], y = linear[1], e = chord_angle;
  const std::array<double, 4>& m3 = rule.third_moments;
  const std::array<double, 3>& m2 = rule.second_moments;
  const double cubes = x * x * x * m3[0] + 3.0 * x * y * (x * m3[1] + y * m3[2]) + y * y * y * m3[3] -
                       3.0 * e * (x * x * m2[0] + 2.0 * x * y * m2[1] + y * y * m2[2]) +
                       3.0 * e * e * (x * rule.first_moment + y * rule.last_moment) - e * e * e;
  return x + cubes / 6.0 / (rule.first_moment - ratio * rule.last_moment);
}

}  // namespace

Solved FixedKnots::solve_free(const RuleTable& rule, const StandardData& data, const Solved* near) const {
  const double chord_angle = data.chord_angle, turning = data.turning;
  // x and y here are times the length. Turning fixes y = (turning - x W_x) / W_y; the scalar equation for x is
  // that the end lies on the chord's line.
  struct End {
    double across, along, across_slope;
  };
  const double ratio = rule.first_total / rule.last_total;
  const auto end_of = [&](double x, double scale) {
    const double y = (scale * turning - x * rule.first_total) / rule.last_total;
    End end{0.0, 0.0, 0.0};
    for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
      const double angle = x * rule.first[i] + y * rule.last[i] - scale * chord_angle;
      const double c = rule.weights[i] * std::cos(angle);
      end.across += rule.weights[i] * std::sin(angle);
      end.along += c;
      end.across_slope += c * (rule.first[i] - ratio * rule.last[i]);
    }
    return end;
  };
  const double start = first_guess(rule, linearised(data), chord_angle, ratio);
  Solved solved{start, 0.0, 1.0, 0, HUGE_VAL, false};

  // Newton at a share `scale` of the angles; true if it ends on a curve that runs forwards.
  const auto refine = [&](double& x, double scale) {
    End at = end_of(x, scale);
    for (int i = 0; i < 30 && std::abs(at.across) > rounding; ++i) {
      double step = -at.across / at.across_slope;
      End next = end_of(x + step, scale);
      ++solved.iterations;
      for (int halvings = 0; !(std::abs(next.across) < std::abs(at.across)) && halvings < 10; ++halvings)
        next = end_of(x + (step *= 0.5), scale);
      if (!(std::abs(next.across) < std::abs(at.across))) break;
      x += step;
      at = next;
    }
    solved.residual = std::abs(at.across) / std::abs(at.along);
    solved.length = 1.0 / at.along;
    return solved.residual <= tolerance && at.along > 0.0;
  };

  double x = near ? near->x * near->length : start;
  solved.converged = refine(x, 1.0);
  if (!solved.converged) {
    // The angles grow from zero; the branch that starts at the linearised solution is the curve without needless turns.
    const auto at_share = [&](double s, const Eigen::Vector3d& guess) {
      double value = guess.x();
      const bool converged = refine(value, s);
      return NewtonResult{{value, 0.0, 0.0}, solved.residual, 0, converged};
    };
    const NewtonResult followed = follow_solution(at_share, Eigen::Vector3d::Zero(), 0.25, 1e-5);
    x = followed.x.x();
    solved.converged = followed.converged;
  }
  solved.x = x / solved.length;
  solved.y = (turning - x * rule.first_total) / rule.last_total / solved.length;
  return solved;
}

ThreeEquations fixed_equations(const RuleTable& rule, const StandardData& data, double share,
                               const Eigen::Vector3d& unknowns) {
  const double x = unknowns[0], y = unknowns[1], length = std::exp(unknowns[2]);
  double sine = 0.0, cosine = 0.0;
  Eigen::Vector3d sines = Eigen::Vector3d::Zero(), cosines = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
    const double per_length = x * rule.first[i] + y * rule.last[i] + share * rule.fixed[i];
    const double angle = length * per_length - share * data.chord_angle;
    const double s = rule.weights[i] * std::sin(angle), c = rule.weights[i] * std::cos(angle);
    const Eigen::Vector3d by(length * rule.first[i], length * rule.last[i], length * per_length);
    sine += s;
    cosine += c;
    sines += s * by;
    cosines += c * by;
  }
  const double turning = length * (x * rule.first_total + y * rule.last_total + share * rule.fixed_total);
  ThreeEquations e;
  e.value << turning - share * data.turning, length * sine, length * cosine - 1.0;
  e.jacobian.row(0) << length * rule.first_total, length * rule.last_total, turning;
  e.jacobian.row(1) = length * (cosines + Eigen::Vector3d(0.0, 0.0, sine)).transpose();
  e.jacobian.row(2) = length * (Eigen::Vector3d(0.0, 0.0, cosine) - sines).transpose();
  return e;
}

Solved FixedKnots::solve_fixed(const RuleTable& rule, const StandardData& data, const Solved* near) const {
  const Eigen::Vector2d start = linearised(data);
  const double size = std::max(1.0, rule_.controls(start[0], start[1]).lpNorm<Eigen::Infinity>());
  const double least = tolerance * std::max(1.0, 0.25 * size);
  const auto solve_at = [&](double share, const Eigen::Vector3d& guess) {
    const auto equations = [&](const Eigen::Vector3d& u) { return fixed_equations(rule, data, share, u); };
    return damped_newton(equations, guess, {4.0 * size, 4.0 * size, 0.7}, least, 15);
  };
  NewtonResult result =
      near ? solve_at(1.0, {near->x, near->y, std::log(near->length)}) : solve_at(1.0, {start[0], start[1], 0.0});
  if (!result.converged) {
    const int spent = result.iterations;
    // All that is given grows from zero, where the linearised problem is the problem.
    result = follow_solution(solve_at, Eigen::Vector3d::Zero(), 0.1, 1e-3);
    result.iterations += spent;
  }
  return {result.x[0], result.x[1], std::exp(result.x[2]), result.iterations, result.residual, result.converged};
}

double FixedKnots::absolute_turning(const Solved& solved) const {
  return solved.length * rule_.controls(solved.x, solved.y).cwiseAbs().dot(integrals_);
}

Solved FixedKnots::solve(const StandardData& data) const {
  const auto solve_with = [&](const RuleTable& rule, const Solved* near) {
    return rule_.free_of_scale() ? solve_free(rule, data, near) : solve_fixed(rule, data, near);
  };
  const Solved rough = solve_with(coarse_, nullptr);
  const double turning = absolute_turning(rough);
  const bool trusted = turning <= ordinary_turning || turning >= too_much_turning;
  if (rough.converged && trusted) return rough;
  const bool ordinary_panels = !rough.converged || turning <= much_turning;
  const Solved* const near = rough.converged ? &rough : nullptr;
  Solved solved = ordinary_panels
                      ? solve_with(fine_, near)
                      : solve_with(RuleTable(angle_table(basis_, panels_for(basis_, turning)), rule_), near);
  solved.iterations += rough.iterations;
  return solved;
}

StandardCurve FixedKnots::curve(const Solved& solved) const {
  const Eigen::VectorXd controls = rule_.controls(solved.x, solved.y);
  return {basis_, {controls.begin(), controls.end()}, solved.length};
}

Solved g1_clothoid(const StandardData& data) {
  static const FixedKnots linear(uniform_basis(1, 2), interpolated(uniform_basis(1, 2), 0, 1, 0.0));
  return linear.solve(data);
}

}  // namespace kappabench::intrinsic
