#include "schemes/segments/rational.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "schemes/segments/polynomial.hpp"

namespace kappabench {

RationalSegment::RationalSegment(RationalForm form) : form_(std::move(form)) {
  const std::size_t count = form_.control_points.size();
  if (count < 2 || count > PolynomialSegment::max_degree + 1)
    throw std::invalid_argument("RationalSegment: 2 to 6 control points are needed");
  if (form_.weights.size() != count) throw std::invalid_argument("RationalSegment: one weight a control point");
  if (!std::ranges::all_of(form_.weights, [](double w) { return w > 0.0 && std::isfinite(w); }))
    throw std::invalid_argument("RationalSegment: weights are positive numbers");
}

Jet RationalSegment::jet(double t, int order) const {
  // c = N / W: polynomials with the weighted points, seen from the first one, and the weights as their controls.
  std::array<Vec2, PolynomialSegment::max_degree + 1> weighted, weights;
  const std::size_t count = form_.control_points.size();
  const Vec2& origin = form_.control_points.front();
  for (std::size_t i = 0; i < count; ++i) {
    weighted[i] = form_.weights[i] * (form_.control_points[i] - origin);
    weights[i] = Vec2(form_.weights[i], 0.0);
  }
  const Jet n = PolynomialSegment(std::span(weighted).first(count)).jet(t, order);
  const Jet w = PolynomialSegment(std::span(weights).first(count)).jet(t, order);
  // Leibniz: N^(k) = sum over j of binomial(k, j) W^(j) c^(k - j).
  Jet jet;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
    jet.d[k] = n.d[k];
    double binomial = 1.0;
    for (std::size_t j = 1; j <= k; ++j) {
      binomial = binomial * static_cast<double>(k - j + 1) / static_cast<double>(j);
      jet.d[k] -= binomial * w.d[j].x() * jet.d[k - j];
    }
    jet.d[k] /= w.d[0].x();
  }
  // The ends are the control points themselves, to the last bit.
  jet.d[0] = t == 1.0 ? form_.control_points.back() : Vec2(origin + jet.d[0]);
  return jet;
}

SegmentPtr RationalSegment::placed(const Placement& placement) const {
  RationalForm form = form_;
  std::ranges::transform(form.control_points, form.control_points.begin(), placement);
  return std::make_shared<RationalSegment>(std::move(form));
}

}  // namespace kappabench
