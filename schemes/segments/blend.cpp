#include "schemes/segments/blend.hpp"

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <numbers>
#include <utility>

namespace kappabench {

namespace {

/// A scalar function of t and its first four derivatives.
using Derivatives = std::array<double, max_jet_order + 1>;

/// Calls `f(k, binomial coefficient)` for the terms of Leibniz' rule of order r.
template <class F>
void leibniz(std::size_t r, F f) {
  std::size_t binomial = 1;
  for (std::size_t k = 0; k <= r; ++k) {
    f(k, static_cast<double>(binomial));
    binomial = binomial * (r - k) / (k + 1);
  }
}

Derivatives product(const Derivatives& f, const Derivatives& g) {
  Derivatives result{};
  for (std::size_t r = 0; r < result.size(); ++r)
    leibniz(r, [&](std::size_t k, double binomial) { result[r] += binomial * f[k] * g[r - k]; });
  return result;
}

Vec2 position(const Segment& segment, double t) { return segment.jet(t, 0).position(); }

}  // namespace

BlendSegment::BlendSegment(SegmentPtr from, SegmentPtr to)
    : from_(std::move(from)),
      to_(std::move(to)),
      start_gap_(position(*from_, 0.0) - position(*to_, 0.0)),
      end_gap_(position(*to_, 1.0) - position(*from_, 1.0)) {}

Jet BlendSegment::jet(double t, int order) const {
  using boost::math::cos_pi;
  using boost::math::sin_pi;  // exact at the ends, where a fast segment's weight must be 0 and not nearly so
  constexpr double pi = std::numbers::pi;
  const double first = cos_pi(0.5 * t), second = sin_pi(0.5 * t);
  // Derivatives of sin^2(pi t / 2) = (1 - cos(pi t)) / 2.
  const double sine = 0.5 * pi * sin_pi(t), cosine = 0.5 * pi * pi * cos_pi(t);
  const Derivatives weight{second * second, sine, cosine, -pi * pi * sine, -pi * pi * cosine};
  const Derivatives rest{first * first, -sine, -cosine, pi * pi * sine, pi * pi * cosine};
  const Derivatives both = product(weight, rest), near_start = product(both, rest), near_end = product(both, weight);
  const Jet from = from_->jet(t, order), to = to_->jet(t, order);
  Jet jet;
  for (std::size_t r = 0; r <= static_cast<std::size_t>(order); ++r) {
    jet.d[r] = rest[0] * from.d[r] + weight[0] * to.d[r];
    leibniz(r, [&](std::size_t k, double binomial) {
      if (k > 0) jet.d[r] += binomial * weight[k] * (to.d[r - k] - from.d[r - k]);
    });
    jet.d[r] += near_start[r] * start_gap_ + near_end[r] * end_gap_;
  }
  return jet;
}

ExactForm BlendSegment::exact() const { return BlendForm{from_, to_}; }

SegmentPtr BlendSegment::placed(const Placement& placement) const {
  return std::make_shared<BlendSegment>(place(from_, placement), place(to_, placement));
}

}  // namespace kappabench
