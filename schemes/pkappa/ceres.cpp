#include <ceres/ceres.h>

#include <cmath>
#include <vector>

#include "schemes/pkappa/free_coordinates.hpp"
#include "schemes/pkappa/solver.hpp"

namespace kappabench::pkappa {
namespace {

/// The residuals as Ceres wants them.
class Residuals final : public ceres::CostFunction {
 public:
  explicit Residuals(FreeCoordinates& coordinates) : coordinates_(coordinates) {
    set_num_residuals(static_cast<int>(coordinates.residuals()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(coordinates.free()));
    for (std::size_t i = 0; i < coordinates.other().size(); ++i) mutable_parameter_block_sizes()->push_back(1);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    return coordinates_.evaluate(parameters, residuals, jacobians);
  }

 private:
  FreeCoordinates& coordinates_;  // with a workspace: Ceres runs with one thread
};

}  // namespace

/// The trust-region Levenberg-Marquardt of Ceres in coordinates without constraints, with bounds for t.
LastIterate run_ceres(FlatProblem& flat, const Eigen::VectorXd& start, const MinimiseOptions& options) {
  FreeCoordinates coordinates(flat, start);
  Residuals cost(coordinates);
  std::vector<double> free(static_cast<std::size_t>(coordinates.free()), 0.0);
  std::vector<double> other;
  for (const Eigen::Index i : coordinates.other()) other.push_back(start[i]);
  std::vector<double*> blocks{free.data()};
  for (double& value : other) blocks.push_back(&value);

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, blocks);
  const Eigen::VectorXd lower = flat.lower(), upper = flat.upper();
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Eigen::Index at = coordinates.other()[i];
    if (!std::isfinite(lower[at])) continue;
    problem.SetParameterLowerBound(&other[i], 0, lower[at]);
    problem.SetParameterUpperBound(&other[i], 0, upper[at]);
  }
  ceres::Solver::Options settings;
  settings.linear_solver_type = ceres::DENSE_QR;
  settings.max_num_iterations = options.max_iterations;
  settings.function_tolerance = options.tolerance;
  settings.gradient_tolerance = settings.parameter_tolerance = 1e-14;
  settings.num_threads = 1;
  settings.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(settings, &problem, &summary);

  LastIterate last{{}, static_cast<int>(summary.iterations.size()), summary.termination_type == ceres::CONVERGENCE};
  const std::vector<const double*> ends(blocks.begin(), blocks.end());
  if (!coordinates.unknowns_at(ends.data(), last.x)) last.x.resize(0);
  return last;
}

std::string version_of_ceres() { return CERES_VERSION_STRING; }

}  // namespace kappabench::pkappa
