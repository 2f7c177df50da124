#include "schemes/pkappa/free_coordinates.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace kappabench::pkappa {

FreeCoordinates::FreeCoordinates(FlatProblem& flat, const Eigen::VectorXd& start) : flat_(flat), start_(start) {
  for (Eigen::Index i = 0; i < start.size(); ++i) (flat_.is_linear(i) ? linear_ : other_).push_back(i);
  const Eigen::MatrixXd a = flat_.miss_jacobian(start)(Eigen::all, linear_);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(a.transpose());
  const Eigen::MatrixXd q = qr.householderQ();
  range_ = q.leftCols(a.rows());
  null_ = q.rightCols(q.cols() - a.rows());
  flat_.rows(start, residuals_, jacobian_);
}

bool FreeCoordinates::unknowns_at(double const* const* coordinates, Eigen::VectorXd& x) const {
  x = start_;
  for (std::size_t i = 0; i < other_.size(); ++i) x[other_[i]] = coordinates[i + 1][0];
  x(linear_) += null_ * Eigen::Map<const Eigen::VectorXd>(coordinates[0], null_.cols());
  const Eigen::MatrixXd a = flat_.miss_jacobian(x)(Eigen::all, linear_) * range_;
  x(linear_) -= range_ * a.partialPivLu().solve(flat_.miss(x));
  return x.allFinite();
}

bool FreeCoordinates::evaluate(double const* const* coordinates, double* residuals, double** jacobians) {
  Eigen::VectorXd x;
  if (!unknowns_at(coordinates, x)) return false;
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
    if (null_.cols() == 1)  // a row-major single column is no type of Eigen's
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

}  // namespace kappabench::pkappa
