#pragma once

#include <Eigen/Core>

namespace kappabench::pkappa {

/// First and second derivatives of the Bernstein basis at the nodes of a rule, a column for each basis function.
template <int Degree>
struct BasisTable {
  Eigen::Array<double, Eigen::Dynamic, Degree + 1> first, second;
};

/// Nodes in [0, 1], ascending, their weights, which sum to 1, and what every integral over Bézier segments needs.
class QuadratureRule {
 public:
  QuadratureRule(Eigen::ArrayXd nodes, const Eigen::ArrayXd& weights);

  [[nodiscard]] const Eigen::ArrayXd& nodes() const { return nodes_; }
  [[nodiscard]] const Eigen::ArrayXd& root_weights() const { return root_weights_; }

  /// Degree 4 or 5.
  template <int Degree>
  [[nodiscard]] const BasisTable<Degree>& basis() const {
    static_assert(Degree == 4 || Degree == 5);
    if constexpr (Degree == 4)
      return quartic_;
    else
      return quintic_;
  }

 private:
  Eigen::ArrayXd nodes_, root_weights_;
  BasisTable<4> quartic_;
  BasisTable<5> quintic_;
};

/// Gauss-Legendre with 32 nodes: what the integrals are minimised with.
[[nodiscard]] const QuadratureRule& gauss_rule();

/// Gauss-Legendre on 4 panels of 32 nodes: where that is not enough.
[[nodiscard]] const QuadratureRule& fine_gauss_rule();

/// Gauss-Legendre on 8 panels of 32 nodes: what results are verified with.
[[nodiscard]] const QuadratureRule& finest_gauss_rule();

/// Wang 2024, Section 6.1: composite Simpson on 100 sub-intervals, each with its midpoint: 201 nodes.
[[nodiscard]] const QuadratureRule& simpson_rule();

}  // namespace kappabench::pkappa
