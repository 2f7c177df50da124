#pragma once

#include <Eigen/Core>
#include <array>

namespace kappabench {

/// The 15-point Gauss-Kronrod rule on [-1, 1] and the polynomial of degree 14 through its nodes.
struct PanelRule {
  static constexpr std::size_t count = 15;
  using Values = Eigen::Matrix<double, 15, 1>;

  std::array<double, count> node{};          ///< ascending
  std::array<double, count> weight{};        ///< of the 15-point rule
  std::array<double, count> gauss_weight{};  ///< of the embedded 7-point Gauss rule, 0 in between
  Eigen::Matrix<double, 15, 15> legendre;    ///< from values at the nodes to Legendre coefficients
  Eigen::Matrix<double, 15, 15> integral;    ///< from values at the nodes to integrals from -1 to each node

  [[nodiscard]] static const PanelRule& get();
};

/// A polynomial given by Legendre coefficients: its value at x, and its integral from -1 to x.
[[nodiscard]] double legendre_value(const PanelRule::Values& coefficients, double x);
[[nodiscard]] double legendre_integral(const PanelRule::Values& coefficients, double x);

/// The error of the 15-point rule from its difference to the 7-point one, as QUADPACK estimates it.
[[nodiscard]] double kronrod_error(double kronrod, double gauss);

}  // namespace kappabench
