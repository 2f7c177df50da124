#include "experiments/python/binding/evaluate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace kappabench::python {

Spot spot_at(const Curve& curve, double t) {
  const double end = curve.size();
  if (std::isnan(t)) return {0, t};
  if (!(t >= 0.0 && t <= end)) {
    if (!curve.closed() || std::isinf(t))
      throw std::invalid_argument(
          fmt::format("t = {} is outside of the curve; give 0 to {}, a segment each unit", t, curve.size()));
    t -= end * std::floor(t / end);
  }
  if (t >= end) return curve.closed() ? Spot{0, 0.0} : Spot{curve.size() - 1, 1.0};
  const int segment = static_cast<int>(t);
  return {segment, t - segment};
}

}  // namespace kappabench::python
