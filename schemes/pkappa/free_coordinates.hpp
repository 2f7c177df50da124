#pragma once

#include <vector>

#include "schemes/pkappa/flat_problem.hpp"

namespace kappabench::pkappa {

/// Coordinates in which interpolation always holds, for a solver without constraints: the unknowns v that enter it
/// linearly are v_0 + Z q + Y s with Y, Z the range and null space of A^T at the start; q is free, s solves the
/// constraints for given q and t (and shapes of joints), which stay coordinates of their own.
///
/// `coordinates` are q and then, one by one, the others; the problem must outlive this object.
class FreeCoordinates {
 public:
  FreeCoordinates(FlatProblem& flat, const Eigen::VectorXd& start);

  /// How many numbers q has, and which unknowns are coordinates of their own.
  [[nodiscard]] Eigen::Index free() const { return null_.cols(); }
  [[nodiscard]] const std::vector<Eigen::Index>& other() const { return other_; }
  [[nodiscard]] Eigen::Index residuals() const { return residuals_.size(); }

  /// All unknowns for given coordinates; false where the constraints cannot be solved.
  [[nodiscard]] bool unknowns_at(double const* const* coordinates, Eigen::VectorXd& x) const;

  /// The residuals whose squares make the objective, and, where `jacobians` and its entries are not null, their
  /// derivatives by each of `coordinates`, by rows. False where they are not finite.
  [[nodiscard]] bool evaluate(double const* const* coordinates, double* residuals, double** jacobians);

 private:
  FlatProblem& flat_;
  Eigen::VectorXd start_, residuals_;
  Eigen::MatrixXd jacobian_;
  std::vector<Eigen::Index> linear_, other_;
  Eigen::MatrixXd range_, null_;
};

}  // namespace kappabench::pkappa
