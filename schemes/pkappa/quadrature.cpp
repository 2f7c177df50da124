#include "schemes/pkappa/quadrature.hpp"

#include <utility>

#include "schemes/numerics/bernstein.hpp"
#include "schemes/numerics/gauss.hpp"

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

QuadratureRule gauss_rule_of(int panels) {
  const std::vector<GaussNode> table = composite_gauss<32>(panels);
  const auto count = static_cast<Eigen::Index>(table.size());
  Eigen::ArrayXd nodes(count), weights(count);
  for (Eigen::Index q = 0; q < count; ++q) {
    nodes[q] = table[static_cast<std::size_t>(q)].at;
    weights[q] = table[static_cast<std::size_t>(q)].weight;
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
  static const QuadratureRule rule = gauss_rule_of(1);
  return rule;
}

const QuadratureRule& fine_gauss_rule() {
  static const QuadratureRule rule = gauss_rule_of(4);
  return rule;
}

const QuadratureRule& finest_gauss_rule() {
  static const QuadratureRule rule = gauss_rule_of(8);
  return rule;
}

const QuadratureRule& simpson_rule() {
  static const QuadratureRule rule = composite_simpson(100);
  return rule;
}

}  // namespace kappabench::pkappa
