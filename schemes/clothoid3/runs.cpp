#include "schemes/clothoid3/runs.hpp"

#include "schemes/segments/three_point_arcs.hpp"

namespace kappabench::clothoid3 {

namespace {

std::vector<bool> corners_of(const Input& input, const Rules& rules) {
  const std::vector<Vec2>& p = input.points;
  const std::size_t n = p.size();
  std::vector<bool> corners(n, false);
  if (rules.compat) {
    // The published code does not test the pair of the last and the first point.
    for (std::size_t i = 0; i + 1 < n; ++i)
      if ((p[i + 1] - p[i]).norm() < rules.corner_distance) corners[i] = corners[i + 1] = true;
    return corners;
  }
  for (std::size_t i = input.closed ? 0 : 1; i < (input.closed ? n : n - 1); ++i)
    corners[i] = folds_back(p[(i + n - 1) % n], p[i], p[(i + 1) % n]);
  return corners;
}

}  // namespace

std::vector<Run> runs_of(const Input& input, const Rules& rules) {
  const std::vector<bool> corners = corners_of(input, rules);
  const std::size_t n = corners.size();
  std::size_t first = 0;
  if (input.closed) {
    while (first < n && !corners[first]) ++first;
    if (first == n) {
      Run whole{{}, true};
      for (std::size_t i = 0; i < n; ++i) whole.points.push_back(i);
      return {whole};
    }
  }
  std::vector<Run> runs{{{first}, false}};
  for (std::size_t k = 1; k <= (input.closed ? n : n - 1); ++k) {
    const std::size_t i = (first + k) % n;
    runs.back().points.push_back(i);
    const bool last = k == (input.closed ? n : n - 1);
    if (corners[i] && !last) runs.push_back({{i}, false});
  }
  return runs;
}

}  // namespace kappabench::clothoid3
