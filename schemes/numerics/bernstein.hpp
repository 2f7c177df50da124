#pragma once

#include <Eigen/Core>

namespace kappabench {

/// Values at t of the Bernstein basis of degree Degree.
template <int Degree>
[[nodiscard]] Eigen::Matrix<double, Degree + 1, 1> bernstein(double t) {
  Eigen::Matrix<double, Degree + 1, 1> b = Eigen::Matrix<double, Degree + 1, 1>::Zero();
  b[0] = 1.0;
  for (int degree = 1; degree <= Degree; ++degree) {
    for (int j = degree; j > 0; --j) b[j] = (1.0 - t) * b[j] + t * b[j - 1];
    b[0] *= 1.0 - t;
  }
  return b;
}

/// The `order`-th derivatives at t of the basis, order 0, 1 or 2, through differences of the basis of lower degree.
template <int Degree>
[[nodiscard]] Eigen::Matrix<double, Degree + 1, 1> bernstein_derivatives(double t, int order) {
  if constexpr (Degree == 0) {
    return Eigen::Matrix<double, 1, 1>::Constant(order == 0 ? 1.0 : 0.0);
  } else {
    if (order == 0) return bernstein<Degree>(t);
    const Eigen::Matrix<double, Degree, 1> lower = bernstein_derivatives<Degree - 1>(t, order - 1);
    Eigen::Matrix<double, Degree + 1, 1> b = Eigen::Matrix<double, Degree + 1, 1>::Zero();
    b.template tail<Degree>() += Degree * lower;
    b.template head<Degree>() -= Degree * lower;
    return b;
  }
}

}  // namespace kappabench
