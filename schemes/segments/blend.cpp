#include "schemes/segments/blend.hpp"

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <numbers>
#include <utility>

namespace kappabench {

BlendSegment::BlendSegment(SegmentPtr from, SegmentPtr to) : from_(std::move(from)), to_(std::move(to)) {}

Jet BlendSegment::jet(double t, int order) const {
  using boost::math::cos_pi;
  using boost::math::sin_pi;  // exact at the ends, where a fast segment's weight must be 0 and not nearly so
  constexpr double pi = std::numbers::pi;
  const double first = cos_pi(0.5 * t), second = sin_pi(0.5 * t);
  // Derivatives of sin^2(pi t / 2) = (1 - cos(pi t)) / 2.
  const double sine = 0.5 * pi * sin_pi(t), cosine = 0.5 * pi * pi * cos_pi(t);
  const std::array<double, max_jet_order + 1> weight{second * second, sine, cosine, -pi * pi * sine, -pi * pi * cosine};
  const Jet from = from_->jet(t, order), to = to_->jet(t, order);
  Jet jet;
  std::array<double, max_jet_order + 1> row{1.0};  // binomial coefficients of the current order
  for (std::size_t r = 0; r <= static_cast<std::size_t>(order); ++r) {
    jet.d[r] = first * first * from.d[r] + weight[0] * to.d[r];
    for (std::size_t k = 1; k <= r; ++k) jet.d[r] += row[k] * weight[k] * (to.d[r - k] - from.d[r - k]);
    if (r < max_jet_order)
      for (std::size_t k = r + 1; k > 0; --k) row[k] += row[k - 1];
  }
  return jet;
}

ExactForm BlendSegment::exact() const { return BlendForm{from_, to_}; }

SegmentPtr BlendSegment::placed(const Placement& placement) const {
  return std::make_shared<BlendSegment>(place(from_, placement), place(to_, placement));
}

}  // namespace kappabench
