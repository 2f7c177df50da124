#include "schemes/segments/polynomial.hpp"

#include <algorithm>
#include <stdexcept>

namespace kappabench {

PolynomialSegment::PolynomialSegment(std::span<const Vec2> control_points)
    : degree_(static_cast<int>(control_points.size()) - 1) {
  if (degree_ < 1 || degree_ > max_degree)
    throw std::invalid_argument("PolynomialSegment: 2 to 6 control points are needed");
  control_points_.fill(Vec2::Zero());
  std::ranges::copy(control_points, control_points_.begin());
}

Jet PolynomialSegment::jet(double t, int order) const {
  // De Casteljau on the control points and their forward differences together: row r of the triangle holds
  // the points of the r-th derivative's control polygon, divided by degree (degree - 1) ... (degree - r + 1).
  Jet jet;
  auto difference = control_points_;
  double factor = 1.0;
  for (int r = 0; r <= order; ++r) {
    if (r > degree_) {
      jet.d[static_cast<std::size_t>(r)] = Vec2::Zero();
      continue;
    }
    auto row = difference;
    const auto last = static_cast<std::size_t>(degree_ - r);
    for (std::size_t level = last; level > 0; --level)
      for (std::size_t j = 0; j < level; ++j) row[j] += t * (row[j + 1] - row[j]);
    jet.d[static_cast<std::size_t>(r)] = factor * row[0];
    for (std::size_t j = 0; j < last; ++j) difference[j] = difference[j + 1] - difference[j];
    factor *= degree_ - r;
  }
  return jet;
}

void PolynomialSegment::jets(std::span<const double> t, int order, std::span<Jet> out) const {
  for (std::size_t i = 0; i < t.size(); ++i) out[i] = PolynomialSegment::jet(t[i], order);
}

ExactForm PolynomialSegment::exact() const {
  const auto points = control_points();
  return PolynomialForm{{points.begin(), points.end()}};
}

SegmentPtr PolynomialSegment::placed(const Placement& placement) const {
  auto points = control_points_;
  const std::span used = std::span{points}.first(control_points().size());
  std::ranges::transform(used, used.begin(), placement);
  return std::make_shared<PolynomialSegment>(used);
}

}  // namespace kappabench
