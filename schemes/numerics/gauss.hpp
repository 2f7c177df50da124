#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cstddef>

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

}  // namespace kappabench
