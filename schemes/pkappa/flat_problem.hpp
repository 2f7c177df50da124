#pragma once

#include <Eigen/Core>
#include <memory>

#include "schemes/pkappa/joint_chain.hpp"

namespace kappabench::pkappa {

/// A window as general optimisers want it, whatever its continuity: a vector of unknowns x with bounds, an objective,
/// and equality constraints (each segment passes its point). The parabolas are eliminated. Keeps a workspace.
class FlatProblem {
 public:
  FlatProblem() = default;
  FlatProblem(const FlatProblem&) = delete;
  FlatProblem& operator=(const FlatProblem&) = delete;
  virtual ~FlatProblem() = default;

  [[nodiscard]] virtual Eigen::Index unknowns() const = 0;
  [[nodiscard]] virtual Eigen::Index constraints() const = 0;
  [[nodiscard]] virtual Eigen::VectorXd values_of(const JointChain& chain) const = 0;
  [[nodiscard]] virtual const JointChain& chain_at(const Eigen::VectorXd& x) = 0;

  /// Infinite where t has no bounds.
  [[nodiscard]] virtual Eigen::VectorXd lower() const = 0;
  [[nodiscard]] virtual Eigen::VectorXd upper() const = 0;

  /// Whether unknown i enters the constraints linearly (coordinates of vectors do, t and the shape of a joint do not).
  [[nodiscard]] virtual bool is_linear(Eigen::Index i) const = 0;

  [[nodiscard]] virtual double objective(const Eigen::VectorXd& x) = 0;
  [[nodiscard]] virtual Eigen::VectorXd gradient(const Eigen::VectorXd& x) = 0;
  /// Gauss-Newton, without the constraints' curvature.
  [[nodiscard]] virtual Eigen::MatrixXd hessian(const Eigen::VectorXd& x) = 0;
  /// The residuals whose squares make the objective, and their derivatives.
  virtual void rows(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) = 0;
  /// By how much each segment misses its point.
  [[nodiscard]] virtual Eigen::VectorXd miss(const Eigen::VectorXd& x) = 0;
  [[nodiscard]] virtual Eigen::MatrixXd miss_jacobian(const Eigen::VectorXd& x) = 0;

  /// Puts t into its box and restores interpolation; the energy then, which is infinite where that cannot be done.
  [[nodiscard]] virtual double make_feasible(JointChain& chain) = 0;
};

template <Continuity K>
[[nodiscard]] std::unique_ptr<FlatProblem> flat_problem(const JointChain& chain, const QuadratureRule& rule,
                                                        const Weights& weights);

}  // namespace kappabench::pkappa
