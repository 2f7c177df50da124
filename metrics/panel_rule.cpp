#include "metrics/panel_rule.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace kappabench {
namespace {

/// P_0 ... P_15 at x.
std::array<double, 16> legendre_polynomials(double x) {
  std::array<double, 16> p{1.0, x};
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    const auto d = static_cast<double>(k);
    p[k + 1] = ((2.0 * d + 1.0) * x * p[k] - d * p[k - 1]) / (d + 1.0);
  }
  return p;
}

/// The integrals from -1 to x of P_0 ... P_14: (P_{k+1} - P_{k-1}) / (2k + 1).
PanelRule::Values legendre_integrals(double x) {
  const auto p = legendre_polynomials(x);
  PanelRule::Values result;
  result[0] = x + 1.0;
  for (std::size_t k = 1; k < PanelRule::count; ++k) {
    result[static_cast<Eigen::Index>(k)] = (p[k + 1] - p[k - 1]) / (2.0 * static_cast<double>(k) + 1.0);
  }
  return result;
}

PanelRule make_rule() {
  using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  PanelRule rule;
  for (std::size_t i = 0; i < 8; ++i) {  // Boost lists the nonnegative half, every second one a Gauss node
    const double x = Kronrod::abscissa()[i];
    const double gauss = i % 2 == 0 ? Gauss::weights()[i / 2] : 0.0;
    for (const auto& [k, sign] : {std::pair{7 - i, -1.0}, std::pair{7 + i, 1.0}}) {
      rule.node[k] = sign * x;
      rule.weight[k] = Kronrod::weights()[i];
      rule.gauss_weight[k] = gauss;
    }
  }
  Eigen::Matrix<double, 15, 15> values;
  Eigen::Matrix<double, 15, 15> integrals;
  for (Eigen::Index i = 0; i < 15; ++i) {
    const double x = rule.node[static_cast<std::size_t>(i)];
    const auto p = legendre_polynomials(x);
    for (Eigen::Index k = 0; k < 15; ++k) values(i, k) = p[static_cast<std::size_t>(k)];
    integrals.row(i) = legendre_integrals(x).transpose();
  }
  rule.legendre = values.inverse();
  rule.integral = integrals * rule.legendre;
  return rule;
}

}  // namespace

const PanelRule& PanelRule::get() {
  static const PanelRule rule = make_rule();
  return rule;
}

double legendre_value(const PanelRule::Values& coefficients, double x) {
  const auto p = legendre_polynomials(x);
  double sum = 0.0;
  for (std::size_t k = 0; k < PanelRule::count; ++k) sum += coefficients[static_cast<Eigen::Index>(k)] * p[k];
  return sum;
}

double legendre_integral(const PanelRule::Values& coefficients, double x) {
  return coefficients.dot(legendre_integrals(x));
}

double kronrod_error(double kronrod, double gauss) {
  const double difference = std::abs(kronrod - gauss);
  const double size = std::abs(kronrod);
  return size > 0.0 ? size * std::min(1.0, std::pow(200.0 * difference / size, 1.5)) : difference;
}

}  // namespace kappabench
