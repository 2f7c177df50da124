#pragma once

#include <Eigen/Core>
#include <array>

#include "schemes/intrinsic/controls.hpp"
#include "schemes/numerics/bspline.hpp"

namespace kappabench::intrinsic {

/// What fixed knots fix: the angle at the nodes of a quadrature rule as a linear function of the control curvatures.
struct AngleTable {
  Eigen::VectorXd weights;    ///< of the nodes, sum 1
  Eigen::MatrixXd integrals;  ///< nodes x m: each basis function integrated from 0 to the node
  Eigen::VectorXd totals;     ///< m: integrated over [0, 1]
};

/// 16-point Gauss-Legendre on `panels` equal parts of every knot span.
[[nodiscard]] AngleTable angle_table(const BSplineBasis& basis, int panels);

/// Parts of a span that make the rule exact to rounding for curves that turn by `turning` radians in all, each radian
/// counted without sign.
[[nodiscard]] int panels_for(const BSplineBasis& basis, double turning);

/// A rule of controls at the same nodes: the angle over the length is first x + last y + fixed.
struct RuleTable {
  RuleTable(const AngleTable& table, const ControlRule& rule);

  Eigen::ArrayXd weights, first, last, fixed;
  double first_total, last_total, fixed_total;     ///< at the end
  double first_moment, last_moment, fixed_moment;  ///< integrated over [0, 1]
  std::array<double, 3> second_moments;            ///< integrals of first^2, first last, last^2
  std::array<double, 4> third_moments;             ///< of first^3, first^2 last, first last^2, last^3
};

}  // namespace kappabench::intrinsic
