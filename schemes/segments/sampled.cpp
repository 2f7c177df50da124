#include "schemes/segments/sampled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "schemes/segments/polynomial.hpp"

namespace kappabench {

namespace {

bool finite(const std::vector<Vec2>& vectors) {
  return std::ranges::all_of(vectors, [](const Vec2& v) { return v.allFinite(); });
}

}  // namespace

SampledSegment::SampledSegment(SampledForm form) : form_(std::move(form)) {
  const std::size_t count = form_.t.size();
  if (count < 2) throw std::invalid_argument("SampledSegment: at least two samples are needed");
  if (form_.position.size() != count || form_.first.size() != count || form_.second.size() != count)
    throw std::invalid_argument("SampledSegment: a position and two derivatives for each parameter");
  // A NaN is before nothing.
  const auto not_before = [](double a, double b) { return !(a < b); };
  const bool ascending = std::ranges::adjacent_find(form_.t, not_before) == form_.t.end();
  if (!ascending || form_.t.front() != 0.0 || form_.t.back() != 1.0)
    throw std::invalid_argument("SampledSegment: parameters ascend from 0 to 1");
  if (!finite(form_.position) || !finite(form_.first) || !finite(form_.second))
    throw std::invalid_argument("SampledSegment: a sample is not finite");
}

Jet SampledSegment::jet(double t, int order) const {
  const auto after = std::upper_bound(form_.t.begin() + 1, form_.t.end() - 1, t);
  const auto j = static_cast<std::size_t>(after - form_.t.begin()), i = j - 1;
  const double h = form_.t[j] - form_.t[i];
  const auto& [all_t, p, v, a] = form_;
  // Derivatives at the ends of a quintic Bézier segment: 5 (b1 - b0) and 20 (b2 - 2 b1 + b0), over h and h^2.
  const std::array<Vec2, 6> controls{p[i],
                                     p[i] + h / 5.0 * v[i],
                                     p[i] + 2.0 * h / 5.0 * v[i] + h * h / 20.0 * a[i],
                                     p[j] - 2.0 * h / 5.0 * v[j] + h * h / 20.0 * a[j],
                                     p[j] - h / 5.0 * v[j],
                                     p[j]};
  Jet jet = PolynomialSegment(controls).jet((t - form_.t[i]) / h, order);
  double scale = 1.0;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(order); ++k) jet.d[k] *= scale /= h;
  return jet;
}

SegmentPtr SampledSegment::placed(const Placement& placement) const {
  SampledForm form = form_;
  std::ranges::transform(form.position, form.position.begin(), placement);
  for (std::vector<Vec2>* derivatives : {&form.first, &form.second})
    for (Vec2& d : *derivatives) d *= placement.scale;
  return std::make_shared<SampledSegment>(std::move(form));
}

}  // namespace kappabench
