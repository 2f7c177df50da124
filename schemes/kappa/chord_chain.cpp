#include "schemes/kappa/chord_chain.hpp"

#include <cmath>
#include <limits>

namespace kappabench::kappa {

ChordChain make_chain(std::span<const Vec2> points, std::span<const double> a, bool closed, BasisKind basis) {
  ChordChain chain{.basis = basis, .closed = closed, .chord = {}, .a = {}, .end = {}, .size = {}};
  const std::size_t n = points.size();
  if (closed) {
    chain.chord.push_back(points[0] - points[n - 1]);
    chain.a.push_back(a[n - 1]);
  }
  for (std::size_t i = 0; i + 1 < n; ++i) chain.chord.push_back(points[i + 1] - points[i]);
  chain.a.insert(chain.a.end(), a.begin(), a.end());
  if (closed) {
    chain.chord.push_back(points[0] - points[n - 1]);
    chain.a.push_back(a[0]);
  }
  for (const double value : chain.a) chain.end.push_back(std::log1p(-value) - 2.0 * std::log(value));
  chain.size.push_back(chain.chord.front().norm());
  for (std::size_t k = 0; k + 1 < chain.chord.size(); ++k)
    chain.size.push_back(0.5 * (chain.chord[k].norm() + chain.chord[k + 1].norm()));
  chain.size.push_back(chain.chord.back().norm());
  return chain;
}

void State::close(const ChordChain& chain) {
  if (!chain.closed) return;
  const std::size_t m = chain.segments();
  e[0] = e[m];
  e[m + 1] = e[1];
  x[0] = x[m];
}

State initial_state(const ChordChain& chain) {
  const std::size_t m = chain.segments();
  State state{std::vector<Vec2>(m + 2, Vec2::Zero()), std::vector<double>(m + 1, 0.0)};
  if (!chain.closed) {
    state.x.front() = -std::numeric_limits<double>::infinity();
    state.x.back() = std::numeric_limits<double>::infinity();
  }
  return state;
}

}  // namespace kappabench::kappa
