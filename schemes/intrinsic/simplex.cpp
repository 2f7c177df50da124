#include "schemes/intrinsic/simplex.hpp"

#include <cmath>
#include <nlopt.hpp>
#include <vector>

namespace kappabench::intrinsic {

namespace {

constexpr double nowhere = 1e10;  ///< the distance where Eq. (8) gives no length

struct Problem {
  const RuleTable& rule;
  const StandardData& data;

  /// Yoshida 2022, Eq. (8).
  [[nodiscard]] double length(double x, double y) const {
    return data.turning / (x * rule.first_total + y * rule.last_total + rule.fixed_total);
  }

  [[nodiscard]] double distance(double x, double y) const {
    const double s = length(x, y);
    if (!(s > 0.0 && s < nowhere)) return nowhere;
    double across = 0.0, along = 0.0;
    for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
      const double angle = s * (x * rule.first[i] + y * rule.last[i] + rule.fixed[i]) - data.chord_angle;
      across += rule.weights[i] * std::sin(angle);
      along += rule.weights[i] * std::cos(angle);
    }
    return std::hypot(s * across, s * along - 1.0);
  }
};

double distance_of(unsigned, const double* x, double*, void* problem) {
  return static_cast<const Problem*>(problem)->distance(x[0], x[1]);
}

}  // namespace

Solved solve_by_simplex(const FixedKnots& knots, const StandardData& data, double tolerance) {
  const Eigen::Vector2d start = knots.linearised(data);
  Problem problem{knots.table(), data};
  nlopt::opt simplex(nlopt::LN_NELDERMEAD, 2);
  simplex.set_min_objective(distance_of, &problem);
  simplex.set_stopval(tolerance);
  simplex.set_maxeval(2000);
  simplex.set_initial_step(0.1 * std::max(start.cwiseAbs().maxCoeff(), 1e-3));
  std::vector<double> x{start[0], start[1]};
  double distance = nowhere;
  try {
    simplex.optimize(x, distance);
  } catch (const nlopt::roundoff_limited&) {
    // The best point so far is in x.
    distance = problem.distance(x[0], x[1]);
  }
  const double length = problem.length(x[0], x[1]);
  return {x[0], x[1], length, simplex.get_numevals(), distance, distance <= tolerance};
}

}  // namespace kappabench::intrinsic
