#include "schemes/pkappa/quadrature.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <utility>

#include "schemes/numerics/bernstein.hpp"

namespace kappabench::pkappa {
namespace {

template <int Degree>
BasisTable<Degree> tabulate(const Eigen::ArrayXd& nodes) {
  BasisTable<Degree> table{{nodes.size(), Degree + 1}, {nodes.size(), Degree + 1}};
  for (Eigen::Index q = 0; q < nodes.size(); ++q) {
    table.first.row(q) = bernstein_derivatives<Degree>(nodes[q], 1).transpose();
    table.second.row(q) = bernstein_derivatives<Degree>(nodes[q], 2).transpose();
  }
  return table;
}

constexpr int gauss_nodes = 32;

/// Boost keeps the nodes of [-1, 1] that are positive, ascending.
QuadratureRule composite_gauss(int panels) {
  using Gauss = boost::math::quadrature::gauss<double, gauss_nodes>;
  Eigen::ArrayXd nodes(panels * gauss_nodes), weights(panels * gauss_nodes);
  constexpr int half = gauss_nodes / 2;
  for (int panel = 0; panel < panels; ++panel) {
    for (int i = 0; i < half; ++i) {
      const double offset = 0.5 * Gauss::abscissa()[static_cast<std::size_t>(i)] / panels;
      const double weight = 0.5 * Gauss::weights()[static_cast<std::size_t>(i)] / panels;
      const double centre = (panel + 0.5) / panels;
      const int above = panel * gauss_nodes + half + i, below = panel * gauss_nodes + half - 1 - i;
      nodes[above] = centre + offset;
      nodes[below] = centre - offset;
      weights[above] = weights[below] = weight;
    }
  }
  return {nodes, weights};
}

QuadratureRule composite_simpson(int intervals) {
  const int n = 2 * intervals + 1;
  Eigen::ArrayXd weights(n);
  for (int i = 0; i < n; ++i) weights[i] = (i == 0 || i == n - 1 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (6.0 * intervals);
  return {Eigen::ArrayXd::LinSpaced(n, 0.0, 1.0), weights};
}

}  // namespace

QuadratureRule::QuadratureRule(Eigen::ArrayXd nodes, const Eigen::ArrayXd& weights)
    : nodes_(std::move(nodes)),
      root_weights_(weights.sqrt()),
      quartic_(tabulate<4>(nodes_)),
      quintic_(tabulate<5>(nodes_)) {}

const QuadratureRule& gauss_rule() {
  static const QuadratureRule rule = composite_gauss(1);
  return rule;
}

const QuadratureRule& fine_gauss_rule() {
  static const QuadratureRule rule = composite_gauss(4);
  return rule;
}

const QuadratureRule& finest_gauss_rule() {
  static const QuadratureRule rule = composite_gauss(8);
  return rule;
}

const QuadratureRule& simpson_rule() {
  static const QuadratureRule rule = composite_simpson(100);
  return rule;
}

}  // namespace kappabench::pkappa
