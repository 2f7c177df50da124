#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "schemes/curve/curve.hpp"

namespace kappabench::python {

/// A place on a curve.
struct Spot {
  int segment;
  double t;  ///< in [0, 1]
};

/// Where parameter `t` of the whole curve lies: segment k is [k, k + 1), the last one of an open curve with its end.
/// Closed curves are periodic. NaN is NaN on the first segment. Throws std::invalid_argument, one line, for a parameter
/// outside of an open curve.
[[nodiscard]] Spot spot_at(const Curve& curve, double t);

/// Calls visit(i, jet) with the jet at t[i] of the whole curve, for every i in order. Neighbours that lie on one
/// segment are evaluated together, as many as stay in the processor's nearest memory. Throws as spot_at.
template <class Visit>
void for_each_jet(const Curve& curve, std::span<const double> t, int order, Visit visit) {
  constexpr std::size_t most = 256;
  std::array<double, most> local;
  std::array<Jet, most> jets;
  if (t.empty()) return;
  Spot next = spot_at(curve, t.front());
  for (std::size_t done = 0; done < t.size();) {
    const int segment = next.segment;
    std::size_t count = 0;
    while (next.segment == segment && count < most) {
      local[count++] = next.t;
      if (done + count == t.size()) break;
      next = spot_at(curve, t[done + count]);
    }
    curve.segment(segment).jets(std::span{local}.first(count), order, std::span{jets}.first(count));
    for (std::size_t j = 0; j < count; ++j) visit(done + j, jets[j]);
    done += count;
  }
}

}  // namespace kappabench::python
