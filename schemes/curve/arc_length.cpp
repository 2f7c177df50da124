#include "schemes/curve/arc_length.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <limits>
#include <vector>

#include "schemes/curve/steady_stretches.hpp"

namespace kappabench {
namespace {

struct Stretch {
  double middle;
  double half;
  double rough_length;
};

/// The steady stretches of [t0, t1], with the middle speed times the width as the length, right up to a factor of 3.
std::vector<Stretch> stretches_between(const Segment& segment, double t0, double t1, double& noise) {
  std::vector<Stretch> stretches;
  const std::vector<double> ends = steady_stretches(segment);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double from = std::max(t0, ends[i]);
    const double to = std::min(t1, ends[i + 1]);
    if (!(from < to)) continue;
    const Jet jet = segment.jet(0.5 * (from + to), 1);
    stretches.push_back({0.5 * (from + to), 0.5 * (to - from), (to - from) * speed(jet)});
    noise += speed_noise(jet) * stretches.back().rough_length;
  }
  return stretches;
}

}  // namespace

double arc_length(const Segment& segment, double t0, double t1, double accuracy) {
  using boost::math::quadrature::gauss_kronrod;
  double noise = 0.0;
  const std::vector<Stretch> stretches = stretches_between(segment, t0, t1, noise);
  double rough = 0.0;
  for (const Stretch& stretch : stretches) rough += stretch.rough_length;
  // A tenth, for Boost's tolerances are relative to each stretch or to rough lengths.
  const double aim = 0.1 * (accuracy * rough + noise);
  double length = 0.0;
  double error = 0.0;
  for (const auto& [middle, half, own] : stretches) {
    // The map from [-1, 1] is ours: on other intervals Boost 1.74 compares a scaled tolerance with an unscaled error,
    // and bisects short ones to the bottom.
    const auto speed_at = [&](double u) { return speed(segment.jet(middle + half * u, 1)); };
    const double share = aim / static_cast<double>(stretches.size());
    const double tolerance = own > 0.0 ? std::min(1.0, std::max(aim / rough, share / own)) : 1.0;
    double missed = 0.0;
    length += half * gauss_kronrod<double, 31>::integrate(speed_at, -1.0, 1.0, 10, tolerance, &missed);
    error += half * missed;
  }
  return error <= accuracy * length + noise ? length : std::numeric_limits<double>::quiet_NaN();
}

double arc_length(const Curve& curve, double accuracy) {
  double length = 0.0;
  for (const SegmentPtr& segment : curve.segments()) length += arc_length(*segment, 0.0, 1.0, accuracy);
  return length;
}

double speed_noise(const Jet& jet) {
  const double v = speed(jet);
  return v > 0.0 ? std::min(1e-6, 0x1p-47 * jet.position().cwiseAbs().maxCoeff() / v) : 0.0;
}

}  // namespace kappabench
