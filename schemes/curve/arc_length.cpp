#include "schemes/curve/arc_length.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace kappabench {

double arc_length(const Segment& segment, double t0, double t1, double accuracy) {
  using boost::math::quadrature::gauss_kronrod;
  const auto speed_at = [&segment](double t) { return speed(segment.jet(t, 1)); };
  return gauss_kronrod<double, 31>::integrate(speed_at, t0, t1, 15, accuracy);
}

double arc_length(const Curve& curve, double accuracy) {
  double length = 0.0;
  for (const SegmentPtr& segment : curve.segments()) length += arc_length(*segment, 0.0, 1.0, accuracy);
  return length;
}

}  // namespace kappabench
