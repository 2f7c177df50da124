#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>
#include <vector>

namespace kappabench {

/// Calls `add(u, weight)` for the nodes of the Gauss-Legendre rule of `Points` points on [from, from + width].
template <int Points, class Add>
void for_gauss_nodes(double from, double width, Add add) {
  using Rule = boost::math::quadrature::gauss<double, Points>;
  const double half = 0.5 * width, middle = from + half;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double offset = half * Rule::abscissa()[i], weight = half * Rule::weights()[i];
    add(middle - offset, weight);
    // An odd rule has its middle node once.
    if (offset != 0.0) add(middle + offset, weight);
  }
}

/// The same on each of `panels` equal parts of [0, 1], one after the other.
template <int Points, class Add>
void for_composite_gauss_nodes(int panels, Add add) {
  for (int k = 0; k < panels; ++k) for_gauss_nodes<Points>(static_cast<double>(k) / panels, 1.0 / panels, add);
}

struct GaussNode {
  double at, weight;
};

/// The composite rule as a table, its nodes ascending.
template <int Points>
[[nodiscard]] std::vector<GaussNode> composite_gauss(int panels) {
  std::vector<GaussNode> nodes;
  for_composite_gauss_nodes<Points>(panels, [&](double u, double weight) { nodes.push_back({u, weight}); });
  std::ranges::sort(nodes, {}, &GaussNode::at);
  return nodes;
}

}  // namespace kappabench
