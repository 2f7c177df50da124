#include "schemes/curve/arc_length.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace kappabench {

double arc_length(const Segment& segment, double t0, double t1, double accuracy) {
  using boost::math::quadrature::gauss_kronrod;
  // The map from [-1, 1] is ours: on other intervals Boost 1.74 compares a scaled tolerance with an unscaled error,
  // and bisects short ones to the bottom.
  const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
  const auto speed_at = [&](double u) { return speed(segment.jet(middle + half * u, 1)); };
  return half * gauss_kronrod<double, 31>::integrate(speed_at, -1.0, 1.0, 10, accuracy);
}

double arc_length(const Curve& curve, double accuracy) {
  double length = 0.0;
  for (const SegmentPtr& segment : curve.segments()) length += arc_length(*segment, 0.0, 1.0, accuracy);
  return length;
}

}  // namespace kappabench
