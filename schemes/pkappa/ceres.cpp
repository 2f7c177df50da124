#include <ceres/ceres.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <memory>
#include <vector>

#include "schemes/pkappa/flat_problem.hpp"
#include "schemes/pkappa/solver.hpp"

namespace kappabench::pkappa {
namespace {

/// Coordinates in which interpolation always holds, for a solver without constraints: the unknowns v that enter it
/// linearly are v_0 + Z q + Y s with Y, Z the range and null space of A^T at the start; q is free, s solves the
/// constraints for given q and t (and shapes of joints), which stay coordinates of their own.
template <Continuity K>
class Eliminated final : public ceres::CostFunction {
 public:
  Eliminated(FlatProblem<K> flat, const Eigen::VectorXd& start) : flat_(std::move(flat)), start_(start) {
    for (Eigen::Index i = 0; i < start.size(); ++i) (flat_.is_linear(i) ? linear_ : other_).push_back(i);
    const Eigen::MatrixXd a = flat_.miss_jacobian(start)(Eigen::all, linear_);
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(a.transpose());
    const Eigen::MatrixXd q = qr.householderQ();
    range_ = q.leftCols(a.rows());
    null_ = q.rightCols(q.cols() - a.rows());
    flat_.rows(start, residuals_, jacobian_);
    set_num_residuals(static_cast<int>(residuals_.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(null_.cols()));
    for (std::size_t i = 0; i < other_.size(); ++i) mutable_parameter_block_sizes()->push_back(1);
  }

  [[nodiscard]] const std::vector<Eigen::Index>& other() const { return other_; }
  [[nodiscard]] Eigen::Index free_coordinates() const { return null_.cols(); }

  /// All unknowns for given coordinates; false where the constraints cannot be solved.
  [[nodiscard]] bool unknowns_at(double const* const* parameters, Eigen::VectorXd& x) const {
    x = start_;
    for (std::size_t i = 0; i < other_.size(); ++i) x[other_[i]] = parameters[i + 1][0];
    x(linear_) += null_ * Eigen::Map<const Eigen::VectorXd>(parameters[0], null_.cols());
    const Eigen::MatrixXd a = flat_.miss_jacobian(x)(Eigen::all, linear_) * range_;
    x(linear_) -= range_ * a.partialPivLu().solve(flat_.miss(x));
    return x.allFinite();
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    Eigen::VectorXd x;
    if (!unknowns_at(parameters, x)) return false;
    flat_.rows(x, residuals_, jacobian_);
    if (!residuals_.allFinite()) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, residuals_.size()) = residuals_;
    if (jacobians == nullptr) return true;

    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::MatrixXd constraint = flat_.miss_jacobian(x), by_linear = constraint(Eigen::all, linear_);
    const Eigen::MatrixXd r_by_linear = jacobian_(Eigen::all, linear_);
    // What s must do for a change of the constraints, carried into the residuals.
    const Eigen::MatrixXd back = r_by_linear * range_ * (by_linear * range_).partialPivLu().inverse();
    if (!back.allFinite()) return false;
    if (jacobians[0] != nullptr) {
      if (null_.cols() == 1)  // Ceres has no row-major single columns
        Eigen::Map<Eigen::VectorXd>(jacobians[0], residuals_.size()) = (r_by_linear - back * by_linear) * null_;
      else
        Eigen::Map<Rows>(jacobians[0], residuals_.size(), null_.cols()) = (r_by_linear - back * by_linear) * null_;
    }
    for (std::size_t i = 0; i < other_.size(); ++i)
      if (jacobians[i + 1] != nullptr)
        Eigen::Map<Eigen::VectorXd>(jacobians[i + 1], residuals_.size()) =
            jacobian_.col(other_[i]) - back * constraint.col(other_[i]);
    return true;
  }

 private:
  mutable FlatProblem<K> flat_;  // its workspace; Ceres runs with one thread
  mutable Eigen::VectorXd residuals_;
  mutable Eigen::MatrixXd jacobian_;
  Eigen::VectorXd start_;
  std::vector<Eigen::Index> linear_, other_;
  Eigen::MatrixXd range_, null_;
};

}  // namespace

/// The trust-region Levenberg-Marquardt of Ceres in coordinates without constraints, with bounds for t.
template <Continuity K>
Minimum minimise_ceres(Chain& chain, const QuadratureRule& rule, const MinimiseOptions& options) {
  FlatProblem<K> flat(chain, rule, options.weights);
  const Eigen::VectorXd start = flat.values_of(chain), lower = flat.lower(), upper = flat.upper();
  Minimum minimum{.energy = flat.objective(start)};
  if (options.max_iterations == 0 || !std::isfinite(minimum.energy)) return minimum;

  auto cost = std::make_unique<Eliminated<K>>(flat, start);
  const Eliminated<K>& eliminated = *cost;
  std::vector<double> free(static_cast<std::size_t>(eliminated.free_coordinates()), 0.0);
  std::vector<double> other;
  for (const Eigen::Index i : eliminated.other()) other.push_back(start[i]);
  std::vector<double*> blocks{free.data()};
  for (double& value : other) blocks.push_back(&value);

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(cost.get(), nullptr, blocks);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Eigen::Index at = eliminated.other()[i];
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
  minimum.iterations = static_cast<int>(summary.iterations.size());
  minimum.converged = summary.termination_type == ceres::CONVERGENCE;

  Eigen::VectorXd x;
  std::vector<const double*> last(blocks.begin(), blocks.end());
  if (eliminated.unknowns_at(last.data(), x))
    accept_if_better<K>(flat.chain_at(x), rule, options.weights, chain, minimum);
  return minimum;
}

template Minimum minimise_ceres<Continuity::c1>(Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_ceres<Continuity::g1>(Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_ceres<Continuity::c2>(Chain&, const QuadratureRule&, const MinimiseOptions&);
template Minimum minimise_ceres<Continuity::g2>(Chain&, const QuadratureRule&, const MinimiseOptions&);

std::string version_of_ceres() { return CERES_VERSION_STRING; }

}  // namespace kappabench::pkappa
