#include "schemes/fpc/cubic_chain.hpp"

#include <cmath>

namespace kappabench::fpc {

namespace {

/// The power of two at or below the mean distance of consecutive points.
double unit_of(std::span<const Vec2> points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return std::exp2(std::ilogb(length / static_cast<double>(points.size() - 1)));
}

}  // namespace

CubicChain make_chain(std::span<const Vec2> points, std::span<const PointTask> tasks, bool closed) {
  const std::size_t m = tasks.size(), n = points.size(), first = closed ? 0 : 1;
  CubicChain chain{.cubic = {}, .chord = {}, .size = {}, .closed = closed, .unit = unit_of(points)};
  chain.cubic.reserve(m);
  chain.chord.reserve(m);
  chain.size.reserve(m);
  const auto leg = [&](std::size_t i) -> Vec2 { return (points[(i + 1) % n] - points[i % n]) / chain.unit; };
  for (std::size_t k = 0; k < m; ++k) {
    const std::size_t i = k + first;
    chain.cubic.emplace_back(tasks[k]);
    chain.chord.push_back(leg(i));
    chain.size.push_back(0.5 * (leg(i + n - 1).norm() + leg(i).norm()));
  }
  if (!closed) {
    chain.start = -leg(0);
    chain.end = leg(n - 2);
  }
  return chain;
}

}  // namespace kappabench::fpc
