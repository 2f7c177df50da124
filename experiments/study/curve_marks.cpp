#include "experiments/study/curve_marks.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "metrics/metric.hpp"
#include "schemes/api/fit.hpp"

namespace kappabench {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

store::CurveRecord empty_mark() {
  store::CurveRecord mark;
  mark.outcome = name(Outcome::converged);
  return mark;
}

void append(store::CurveRecord& mark, double x, double y, double s) {
  mark.sample_x.push_back(x);
  mark.sample_y.push_back(y);
  mark.sample_s.push_back(s);
  mark.sample_kappa.push_back(undefined);
  mark.sample_normal_x.push_back(undefined);
  mark.sample_normal_y.push_back(undefined);
  ++mark.samples_per_segment;
}

}  // namespace

store::CurveRecord stretch_of(const store::CurveRecord& whole, double s0, double s1) {
  store::CurveRecord mark = empty_mark();
  if (whole.sample_s.empty()) return mark;
  const double length = whole.sample_s.back(), rounding = 1e-9 * length;
  for (const double turn : {-length, 0.0, length}) {
    if (!whole.closed && turn != 0.0) continue;
    for (std::size_t i = 0; i < whole.sample_s.size(); ++i) {
      const double s = whole.sample_s[i] + turn;
      if (s >= s0 - rounding && s <= s1 + rounding) append(mark, whole.sample_x[i], whole.sample_y[i], s);
    }
  }
  return mark;
}

store::CurveRecord ring_around(const Vec2& centre, double radius, int corners) {
  store::CurveRecord mark = empty_mark();
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k % corners) / corners;
    append(mark, centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle), radius * k);
  }
  return mark;
}

}  // namespace kappabench
