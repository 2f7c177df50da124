#pragma once

#include <Eigen/Core>
#include <vector>

#include "schemes/pkappa/solver.hpp"
#include "schemes/pkappa/system.hpp"

namespace kappabench::pkappa {

/// A window as general optimisers want it: a vector of unknowns x with bounds, an objective, and equality constraints
/// (each segment passes its point). The parabolas are eliminated.
template <Continuity K>
class FlatProblem {
 public:
  FlatProblem(const JointChain& chain, const QuadratureRule& rule, const Weights& weights);

  [[nodiscard]] Eigen::Index unknowns() const { return static_cast<Eigen::Index>(places_.size()); }
  [[nodiscard]] Eigen::Index constraints() const { return 2 * static_cast<Eigen::Index>(chain_.size()); }
  [[nodiscard]] Eigen::VectorXd values_of(const JointChain& chain) const;
  [[nodiscard]] const JointChain& chain_at(const Eigen::VectorXd& x);

  /// Infinite where t has no bounds.
  [[nodiscard]] Eigen::VectorXd lower() const { return bounds(-1.0); }
  [[nodiscard]] Eigen::VectorXd upper() const { return bounds(1.0); }

  /// Whether unknown i enters the constraints linearly (coordinates of vectors do, t and the shape of a joint do not).
  [[nodiscard]] bool is_linear(Eigen::Index i) const;

  [[nodiscard]] double objective(const Eigen::VectorXd& x);
  [[nodiscard]] Eigen::VectorXd gradient(const Eigen::VectorXd& x);
  /// Gauss-Newton, without the constraints' curvature.
  [[nodiscard]] Eigen::MatrixXd hessian(const Eigen::VectorXd& x);
  /// The residuals whose squares make the objective, and their derivatives.
  void rows(const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian);
  [[nodiscard]] Eigen::VectorXd miss(const Eigen::VectorXd& x);
  [[nodiscard]] Eigen::MatrixXd miss_jacobian(const Eigen::VectorXd& x);

 private:
  struct Place {
    std::size_t block;
    int at;
  };
  [[nodiscard]] Eigen::VectorXd bounds(double sign) const;
  void linearise_at(const Eigen::VectorXd& x);

  JointChain chain_;
  ChainSystem<K> system_;
  SegmentEnergy<Layout<K>::degree> energy_;
  Weights weights_;
  std::vector<Place> places_;
  Eigen::VectorXd linearised_;  ///< where system_ stands
};

/// Ends a general optimiser's run: `found` with its interpolation restored becomes `chain` if its energy is less than
/// `minimum.energy`, which it then becomes; else the run counts as not converged.
template <Continuity K>
void accept_if_better(JointChain found, const QuadratureRule& rule, const Weights& weights, JointChain& chain,
                      Minimum& minimum);

}  // namespace kappabench::pkappa
