#include "schemes/fpc/local_cubic.hpp"

#include <limits>
#include <stdexcept>

namespace kappabench::fpc {

double singular_h(double t) {
  const double skew = 2.0 * t - 1.0;
  return skew == 0.0 ? std::numeric_limits<double>::infinity() : t * (1.0 - t) / (2.0 * skew);
}

bool admissible_h(double t, double h) { return h < -0.5 * t || h > 0.5 * (1.0 - t); }

namespace {

/// The first four coefficients; the others are their sums, by invariance under translations.
std::array<double, 4> coefficients(const PointTask& task) {
  const double t = task.t, u = 1.0 - t;
  switch (task.type) {
    case PointType::cusp:
      return {u * u / (t * t), -(3.0 - t) / u, -(t + 2.0) / t, t * t / (u * u)};
    case PointType::loop: {
      const double t1 = task.t1, t2 = task.t2, u1 = 1.0 - t1, u2 = 1.0 - t2;
      return {u1 * u2 / (t1 * t2), -(t1 * t2 - 2.0 * t1 - 2.0 * t2 + 3.0) / (u1 * u2), -(t1 * t2 + t1 + t2) / (t1 * t2),
              t1 * t2 / (u1 * u2)};
    }
    case PointType::inflection: {
      const double h = task.h, d = t * t + 4.0 * h * t - 2.0 * h - t;
      return {1.0 - (2.0 * t * t + 6.0 * h * t - 3.0 * t - 4.0 * h + 1.0) / (t * d),
              -(2.0 * t * t - 2.0 * t + 6.0 * h * t - 4.0 * h) / (u * d) - 1.0,
              -(2.0 * t * t - 2.0 * t + 6.0 * h * t - 2.0 * h) / (t * d) - 1.0,
              -(t * t * t + 4.0 * h * t * t) / (u * d)};
    }
    case PointType::regular: {
      const double d = -t * u * (t + 3.0) * (2.0 * t + 1.0);
      return {2.0 * u * u * (t * t + 4.0 * t + 1.0) / d, -2.0 * t * (t * t * t + 2.0 * t * t - 6.0 * t - 3.0) / d,
              -(2.0 * t * t * t * t + 6.0 * t * t * t + 3.0 * t * t - 8.0 * t - 3.0) / d,
              t * t * (2.0 * t * t + 6.0 * t + 3.0) / d};
    }
  }
  throw std::logic_error("joint_coefficients: not a type of point");
}

}  // namespace

std::array<double, 6> joint_coefficients(const PointTask& task) {
  const auto [m1, m2, m3, m4] = coefficients(task);
  return {m1, m2, m3, m4, m1 + m2, m3 + m4};
}

// With D = Y - X the chord of the segment, Hermite interpolation gives Q''(0)/2 = 3D - 2Q'(0) - Q'(1) and
// Q''(1)/2 = Q'(0) + 2Q'(1) - 3D.
LocalCubic::LocalCubic(const PointTask& given) : task(given) {
  const auto [m1, m2, m3, m4] = coefficients(given);
  start_x = m3;
  start_y = m4;
  end_x = -m1;
  end_y = -m2;
  const double t = given.t, u = 1.0 - t;
  switch (given.type) {
    case PointType::cusp:
      start_numerator = 3.0 / (u * u);
      end_numerator = 3.0 / (t * t);
      break;
    case PointType::loop: {
      const double t1 = given.t1, t2 = given.t2, u1 = 1.0 - t1, u2 = 1.0 - t2, all = t1 * t2 * u1 * u2;
      start_numerator = (t1 * t1 + t1 * t2 + t2 * t2) / all;
      end_numerator = (u1 * u1 + u1 * u2 + u2 * u2) / all;
      break;
    }
    case PointType::inflection:
    case PointType::regular: {
      // The two are a quadratic's values at 0 and 1, of which the roots are known (Eqs. (9), (10), (12)): the larger
      // one by Hermite, the other by their ratio.
      const double root1 = given.type == PointType::regular ? -1.0 : t;
      const double root2 = given.type == PointType::regular ? 2.0 * t + 1.0 : t + 2.0 * given.h;
      start_numerator = 3.0 * (m3 + m4) + m2 * m3 - m1 * m4;
      end_numerator = 3.0 * (m1 + m2) + m2 * m3 - m1 * m4;
      const double at_start = root1 * root2, at_end = (1.0 - root1) * (1.0 - root2);
      if (at_start * at_start > at_end * at_end) {
        end_numerator = start_numerator * at_end / at_start;
      } else {
        start_numerator = end_numerator * at_start / at_end;
      }
      break;
    }
  }
}

}  // namespace kappabench::fpc
