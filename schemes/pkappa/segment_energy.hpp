#pragma once

#include <Eigen/Core>

#include "schemes/curve/vec.hpp"
#include "schemes/pkappa/quadrature.hpp"

namespace kappabench::pkappa {

/// Control points c_0, ..., c_k of a Bézier segment as columns.
template <int Degree>
using ControlPolygon = Eigen::Matrix<double, 2, Degree + 1>;

/// The weights lambda_e and lambda_c of Wang 2024, Eq. (9), and that of E_p, which is 1 there.
struct Weights {
  double edges;
  double length;
  double parabola = 1.0;

  /// Those that give a segment the weighted energy that it has with lengths over `unit`: E_e is a length to the
  /// fourth power, E_c one to the second and E_p one to the power of -1.
  [[nodiscard]] Weights in(double unit) const {
    const double squared = unit * unit;
    return {edges / (squared * squared), length / squared, parabola * unit};
  }
};

/// Q(t) = vertex_value + steepness (t - t_i)^2: Wang's parabola with its vertex at t_i by construction, so that
/// straight and circular pieces (steepness 0) are as good as any.
struct VertexParabola {
  double vertex_value = 0.0;
  double steepness = 0.0;
};

/// The three terms of Wang 2024, Eqs. (3) to (5).
struct EnergyTerms {
  double parabola = 0.0;
  double edges = 0.0;
  double length = 0.0;

  [[nodiscard]] double weighted(const Weights& w) const {
    return w.parabola * parabola + w.edges * edges + w.length * length;
  }
};

/// The weighted energy of one segment to second order in its control points (x_0, y_0, ..., x_k, y_k) and t_i, halved.
/// The parabola is the best one for them: it enters linearly and is eliminated (variable projection, Golub and Pereyra
/// 1973, with Kaufman's Jacobian 1975). E_p counts as a sum of squares to first order (Gauss-Newton: its residuals are
/// small), the edge terms, which are not small, exactly.
template <int Degree>
struct SegmentNormal {
  static constexpr int size = 2 * (Degree + 1) + 1;
  Eigen::Matrix<double, size, size> hessian;
  Eigen::Matrix<double, size, 1> gradient;
  EnergyTerms terms;
};

/// Evaluates energies with one quadrature rule. Keeps a workspace: one object a thread.
template <int Degree>
class SegmentEnergy {
 public:
  static constexpr int size = SegmentNormal<Degree>::size;

  explicit SegmentEnergy(const QuadratureRule& rule);

  /// Infinite `parabola` where a node meets a cusp or the numbers overflow.
  [[nodiscard]] EnergyTerms terms(const ControlPolygon<Degree>& control, double t);

  /// The parabola that attains `terms(...).parabola`.
  [[nodiscard]] VertexParabola parabola(const ControlPolygon<Degree>& control, double t);

  /// `terms` with first-order information. Meaningless derivatives where `terms` is infinite.
  void normal(const ControlPolygon<Degree>& control, double t, const Weights& weights, SegmentNormal<Degree>& out);

  /// The sum of squares itself: residuals and their derivatives by the coordinates and t, a row each: first those of
  /// E_p with the parabola eliminated, then those of Eqs. (4) and (5).
  void rows(const ControlPolygon<Degree>& control, double t, const Weights& weights, Eigen::VectorXd& residuals,
            Eigen::Matrix<double, Eigen::Dynamic, size>& jacobian);

 private:
  using Column = Eigen::ArrayXd;
  /// Derivatives of the residuals to the coordinates and t, then those to the parabola's two numbers.
  using Table = Eigen::Matrix<double, Eigen::Dynamic, size + 2>;

  double residuals(const ControlPolygon<Degree>& control, double t);
  void differentiate(double t);

  const QuadratureRule* rule_;
  Column x1_, y1_, x2_, y2_, squared_speed_, root_, curvature_, offset_, residual_;
  Column along_, across_, by_x1_, by_y1_, by_x2_, by_y2_;
  Table table_;
  Eigen::Matrix2d parabola_gram_;
  VertexParabola parabola_;
};

/// Wang 2024, Eqs. (4) and (5).
template <int Degree>
[[nodiscard]] double edge_energy(const ControlPolygon<Degree>& control);
template <int Degree>
[[nodiscard]] double length_energy(const ControlPolygon<Degree>& control);

}  // namespace kappabench::pkappa
