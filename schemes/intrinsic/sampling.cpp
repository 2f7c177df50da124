#include "schemes/intrinsic/sampling.hpp"

#include <cstddef>

namespace kappabench::intrinsic {

namespace {

/// From the Bernstein coefficients of the curvature on a span to the powers of the angle: row k is that of x^k.
Eigen::MatrixXd angle_powers(int degree, double width) {
  // Bernstein coefficients of the angle are running sums, its powers their forward differences.
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(degree + 2, degree + 1);
  for (int i = 0; i <= degree; ++i) {
    rows.row(i + 1) = rows.row(i);
    rows(i + 1, i) += width / (degree + 1);
  }
  double factor = 1.0;
  for (int k = 0; k <= degree + 1; ++k) {
    for (int i = degree + 1; i > k; --i) rows.row(i) -= rows.row(i - 1).eval();
    rows.row(k) *= factor;
    factor *= (degree + 1.0 - k) / ((k + 1.0) * width);
  }
  return rows;
}

}  // namespace

Sampler::Sampler(const BSplineBasis& basis, int count) : count_(count) {
  const auto parameter = [&](int k) { return k + 1 == count ? 1.0 : static_cast<double>(k) / (count - 1); };
  int sample = 0;
  for (const KnotSpan& knots : spans_of(basis)) {
    Span span{.first_control = knots.first,
              .to_powers = angle_powers(basis.degree, knots.width()) * knots.to_bernstein,
              .x = {},
              .half_step = {},
              .correction = {},
              .first_sample = sample,
              .samples = 0,
              .first_sampled_node = parameter(sample) == knots.from ? 0 : 1};
    std::vector<double> x;
    if (span.first_sampled_node == 1) x.push_back(0.0);
    for (; sample < count && parameter(sample) <= knots.to; ++sample) x.push_back(parameter(sample) - knots.from);
    span.samples = sample - span.first_sample;
    if (x.back() != knots.width()) x.push_back(knots.width());
    // A sample at a knot ends this span and starts the next one, too.
    if (sample > 0 && sample < count && parameter(sample - 1) == knots.to) --sample, --span.samples;
    span.x = Eigen::Map<const Eigen::ArrayXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    const Eigen::ArrayXd h = span.x.tail(span.x.size() - 1) - span.x.head(span.x.size() - 1);
    span.half_step = 0.5 * h;
    span.correction = h * h / 12.0;
    spans_.push_back(std::move(span));
  }
}

std::vector<Vec2> Sampler::points(const StandardCurve& curve, double chord_angle, Sines sines) const {
  using Eigen::ArrayXd;
  std::vector<Vec2> points(static_cast<std::size_t>(count_));
  const Eigen::Index most = count_ + 2;
  ArrayXd angle(most), rate(most), sine(most), cosine(most), dx(most), dy(most);
  Vec2 position = Vec2::Zero();
  double start = -chord_angle;
  for (const Span& span : spans_) {
    const Eigen::Index n = span.x.size(), degree = span.to_powers.rows() - 1;
    const Eigen::VectorXd power =
        curve.length *
        (span.to_powers * Eigen::Map<const Eigen::VectorXd>(curve.controls.data() + span.first_control, degree));
    auto angles = angle.head(n), rates = rate.head(n);
    angles.setConstant(power[degree]);
    rates.setZero();
    for (Eigen::Index i = degree; i-- > 0;) {
      rates = rates * span.x + angles;
      angles = angles * span.x + (i == 0 ? start : power[i]);
    }
    start = angles[n - 1];
    const auto size = static_cast<std::size_t>(n);
    sine_cosine(sines, {angle.data(), size}, {sine.data(), size}, {cosine.data(), size});

    // Euler-Maclaurin: the trapezium rule and its first correction, by the derivative rate * (-sine, cosine).
    const auto s0 = sine.head(n - 1), s1 = sine.segment(1, n - 1);
    const auto c0 = cosine.head(n - 1), c1 = cosine.segment(1, n - 1);
    const auto r0 = rate.head(n - 1), r1 = rate.segment(1, n - 1);
    dx.head(n - 1) = curve.length * (span.half_step * (c0 + c1) + span.correction * (r1 * s1 - r0 * s0));
    dy.head(n - 1) = curve.length * (span.half_step * (s0 + s1) - span.correction * (r1 * c1 - r0 * c0));
    Vec2* const sampled = points.data() + span.first_sample - span.first_sampled_node;
    if (span.first_sampled_node == 0) sampled[0] = position;
    const Eigen::Index last_sampled = span.first_sampled_node + span.samples;
    for (Eigen::Index i = 1; i < n; ++i) {
      position += Vec2(dx[i - 1], dy[i - 1]);
      if (i < last_sampled) sampled[i] = position;
    }
  }
  return points;
}

}  // namespace kappabench::intrinsic
