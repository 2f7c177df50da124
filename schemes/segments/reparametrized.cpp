#include "schemes/segments/reparametrized.hpp"

#include <stdexcept>
#include <utility>

namespace kappabench {

ReparametrizedSegment::ReparametrizedSegment(SegmentPtr of, double start_speed)
    : of_(std::move(of)), start_speed_(start_speed) {
  if (!(start_speed > 0.0)) throw std::invalid_argument("ReparametrizedSegment: the speed at the start must be > 0");
}

Jet ReparametrizedSegment::jet(double t, int order) const {
  // 1 - t and t have all their digits, 1 + (m - 1) t would lose them for small m at the end.
  const double m = start_speed_, c = m - 1.0, q = 1.0 / ((1.0 - t) + m * t);
  const Jet inner = of_->jet(m * t * q, order);
  const double x1 = m * q * q, x2 = -2.0 * c * q * x1, x3 = -3.0 * c * q * x2, x4 = -4.0 * c * q * x3;
  // Faa di Bruno's formula.
  Jet jet;
  jet.d[0] = inner.d[0];
  if (order >= 1) jet.d[1] = x1 * inner.d[1];
  if (order >= 2) jet.d[2] = x1 * x1 * inner.d[2] + x2 * inner.d[1];
  if (order >= 3) jet.d[3] = x1 * x1 * x1 * inner.d[3] + 3.0 * x1 * x2 * inner.d[2] + x3 * inner.d[1];
  if (order >= 4)
    jet.d[4] = x1 * x1 * x1 * x1 * inner.d[4] + 6.0 * x1 * x1 * x2 * inner.d[3] +
               (4.0 * x1 * x3 + 3.0 * x2 * x2) * inner.d[2] + x4 * inner.d[1];
  return jet;
}

ExactForm ReparametrizedSegment::exact() const { return ReparametrizedForm{of_, start_speed_}; }

SegmentPtr ReparametrizedSegment::placed(const Placement& placement) const {
  return std::make_shared<ReparametrizedSegment>(place(of_, placement), start_speed_);
}

}  // namespace kappabench
