#include "schemes/intrinsic/sampling.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace kappabench::intrinsic {

namespace {

constexpr std::size_t most_coefficients = 11;

/// The angle on a knot span: power coefficients over t - from.
struct AngleSpan {
  double from, to;
  std::array<double, most_coefficients> power;
};

/// From Bernstein to power coefficients by forward differences.
void to_powers(std::array<double, most_coefficients>& c, int degree, double width) {
  double binomial = 1.0, scale = 1.0;
  for (int k = 0; k <= degree; ++k) {
    for (int i = degree; i > k; --i) c[static_cast<std::size_t>(i)] -= c[static_cast<std::size_t>(i) - 1];
    c[static_cast<std::size_t>(k)] *= binomial * scale;
    binomial = binomial * (degree - k) / (k + 1);
    scale /= width;
  }
}

std::vector<AngleSpan> angle_spans(const StandardCurve& curve, double start) {
  const int n = curve.basis.degree;
  std::vector<AngleSpan> result;
  for (const KnotSpan& span : spans_of(curve.basis)) {
    const Eigen::VectorXd curvature =
        span.to_bernstein * Eigen::Map<const Eigen::VectorXd>(curve.controls.data() + span.first, n + 1);
    AngleSpan angle{span.from, span.to, {}};
    angle.power[0] = start;
    for (int i = 0; i <= n; ++i)
      angle.power[static_cast<std::size_t>(i) + 1] = start += curve.length * span.width() * curvature[i] / (n + 1);
    to_powers(angle.power, n + 1, span.width());
    result.push_back(angle);
  }
  return result;
}

}  // namespace

std::vector<Vec2> sample_points(const StandardCurve& curve, double chord_angle, int count, Sines sines) {
  using Eigen::ArrayXd;
  const std::vector<AngleSpan> spans = angle_spans(curve, -chord_angle);
  const int degree = curve.basis.degree + 1;
  const auto parameter = [&](int k) { return k + 1 == count ? 1.0 : static_cast<double>(k) / (count - 1); };

  std::vector<Vec2> points(static_cast<std::size_t>(count));
  const Eigen::Index most_nodes = count + 2;
  ArrayXd x(most_nodes), angle(most_nodes), rate(most_nodes), sine(most_nodes), cosine(most_nodes);
  Vec2 position = Vec2::Zero();
  int sample = 0;
  for (const AngleSpan& span : spans) {
    // The nodes of a span are its ends and the samples between them, relative to its start.
    const int first_sample = sample;
    Eigen::Index n = 0, first_node = 0;
    x[n++] = 0.0;
    if (parameter(sample) != span.from)
      first_node = 1;
    else
      ++sample;
    for (; sample < count && parameter(sample) <= span.to; ++sample) x[n++] = parameter(sample) - span.from;
    if (x[n - 1] != span.to - span.from) x[n++] = span.to - span.from;

    const auto xs = x.head(n);
    auto angles = angle.head(n), rates = rate.head(n);
    angles.setConstant(span.power[static_cast<std::size_t>(degree)]);
    rates.setZero();
    for (int i = degree; i-- > 0;) {
      rates = rates * xs + angles;
      angles = angles * xs + span.power[static_cast<std::size_t>(i)];
    }
    const auto size = static_cast<std::size_t>(n);
    sine_cosine(sines, {angle.data(), size}, {sine.data(), size}, {cosine.data(), size});

    // Euler-Maclaurin: the trapezium rule and its first correction, by the derivative rate * (-sine, cosine).
    const auto h = (xs.tail(n - 1) - xs.head(n - 1)) * curve.length;
    const auto correction = h * (xs.tail(n - 1) - xs.head(n - 1)) / 12.0;
    const auto s0 = sine.head(n - 1), s1 = sine.segment(1, n - 1);
    const auto c0 = cosine.head(n - 1), c1 = cosine.segment(1, n - 1);
    const auto r0 = rate.head(n - 1), r1 = rate.segment(1, n - 1);
    const ArrayXd dx = 0.5 * h * (c0 + c1) + correction * (r1 * s1 - r0 * s0);
    const ArrayXd dy = 0.5 * h * (s0 + s1) - correction * (r1 * c1 - r0 * c0);
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i > 0) position += Vec2(dx[i - 1], dy[i - 1]);
      const Eigen::Index k = first_sample + i - first_node;
      if (i >= first_node && k < sample) points[static_cast<std::size_t>(k)] = position;
    }
  }
  return points;
}

}  // namespace kappabench::intrinsic
