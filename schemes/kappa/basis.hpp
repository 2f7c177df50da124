#pragma once

#include <cmath>
#include <numbers>

namespace kappabench::kappa {

// Both bases of the family write a segment over three control points c_0, c_1, c_2 as
//   c(t) = b_0(t) c_0 + b_1(t) c_1 + b_2(t) c_2,   b_0 + b_1 + b_2 = 1,   b_1 = k w,
// with a constant k and a bubble w that vanishes at both ends. The solver needs no more of a basis than this:
//
// * blend: b_0, b_1, b_2.
// * pencil: with p = c(t) and X = c_0 - p, Y = c_2 - p, eliminating c_1 gives w c'(t) = V, where
//   V = v_0(t) X + v_2(t) Y, v_j = w b_j' - w' b_j. The functions come divided by nothing and expanded nowhere,
//   so that they keep their digits at both ends.
// * legs: c'(t) = f(t) r + g(t) s with the legs r = c_1 - c_0, s = c_2 - c_1.
// * factor: nu(t), det(c', c'') = constant * nu(t) * det(r, s), the part of the curvature's numerator that varies.
//
// Derivatives are with respect to the basis's own parameter in [0, last]; a segment's t is parameter / last.

/// Values at one parameter; `d` and `dd` are first and second derivatives.
struct Blend {
  double b0, b1, b2, bubble;
};
/// Coefficients of two vectors.
struct Pair {
  double first, second;
  double dfirst, dsecond;
  double ddfirst, ddsecond;
};
struct Factor {
  double nu, dnu, ddnu;
};

/// Cubic Bernstein with both inner control points on the legs (Miura 2022, Eq. (1)); a = 2/3 is quadratic.
/// 2/3 <= a < 1.
class CubicBasis {
 public:
  static constexpr double last = 1.0;

  explicit CubicBasis(double a) : a_(a), b_(2.0 - 3.0 * a) {}

  [[nodiscard]] double bubble_factor() const { return 3.0 * a_; }

  [[nodiscard]] Blend blend(double t) const {
    const double u = 1.0 - t;
    return {u * u * (1.0 + b_ * t), 3.0 * a_ * t * u, t * t * (1.0 + b_ * u), t * u};
  }

  [[nodiscard]] Pair pencil(double t) const {
    const double u = 1.0 - t;
    return {.first = -u * u * (1.0 + b_ * t * t),
            .second = t * t * (1.0 + b_ * u * u),
            .dfirst = 2.0 * u * (1.0 + b_ * t * (2.0 * t - 1.0)),
            .dsecond = 2.0 * t * (1.0 + b_ * u * (1.0 - 2.0 * t)),
            .ddfirst = -2.0 + b_ * (2.0 * t - 4.0 * t * t - 2.0 * u + 8.0 * t * u),
            .ddsecond = 2.0 - b_ * (2.0 * u - 4.0 * u * u - 2.0 * t + 8.0 * t * u)};
  }

  [[nodiscard]] Pair legs(double t) const {
    const double u = 1.0 - t;
    return {.first = u * (2.0 - b_ + 3.0 * b_ * t),
            .second = t * (2.0 - b_ + 3.0 * b_ * u),
            .dfirst = -(2.0 - b_ + 3.0 * b_ * t) + 3.0 * b_ * u,
            .dsecond = (2.0 - b_ + 3.0 * b_ * u) - 3.0 * b_ * t,
            .ddfirst = -6.0 * b_,
            .ddsecond = -6.0 * b_};
  }

  /// (1 - a) + (3 a - 2) t (1 - t): the numerator of Eq. (3), simplified.
  [[nodiscard]] Factor factor(double t) const {
    return {(1.0 - a_) - b_ * t * (1.0 - t), -b_ * (1.0 - 2.0 * t), 2.0 * b_};
  }

 private:
  double a_, b_;
};

/// Quadratic trigonometric (Miura 2022, Eq. (17), in the form of Eq. (29) with alpha = 2 a). 1/2 <= a < 1.
/// The parameter is the angle pi t / 2.
class TrigonometricBasis {
 public:
  static constexpr double last = std::numbers::pi / 2.0;

  explicit TrigonometricBasis(double a) : alpha_(2.0 * a), m_(2.0 * a - 1.0) {}

  [[nodiscard]] double bubble_factor() const { return alpha_; }

  [[nodiscard]] Blend blend(double angle) const {
    const At q(angle);
    return {q.u * (1.0 - m_ * q.s), alpha_ * q.v, q.w * (1.0 - m_ * q.c), q.v};
  }

  [[nodiscard]] Pair pencil(double angle) const {
    const auto [s, c, u, v, w] = At(angle);
    const double p = 1.0 - m_ * s + m_ * c * v, q = 1.0 - m_ * c + m_ * s * v;
    const double dp = m_ * (c * (c - s) - c - s * v), dq = m_ * (s * (c - s) + s + c * v);
    const double ddp = m_ * (s - c * v - 2.0 * s * (c - s) - c * (s + c));
    const double ddq = m_ * (c - s * v + 2.0 * c * (c - s) - s * (s + c));
    return {.first = -u * p,
            .second = w * q,
            .dfirst = c * p - u * dp,
            .dsecond = s * q + w * dq,
            .ddfirst = -s * p + 2.0 * c * dp - u * ddp,
            .ddsecond = c * q + 2.0 * s * dq + w * ddq};
  }

  [[nodiscard]] Pair legs(double angle) const {
    const double s = std::sin(angle), c = std::cos(angle);
    const double f = alpha_ - 2.0 * m_ * s, g = alpha_ - 2.0 * m_ * c;
    return {.first = c * f,
            .second = s * g,
            .dfirst = -s * f - 2.0 * m_ * c * c,
            .dsecond = c * g + 2.0 * m_ * s * s,
            .ddfirst = -alpha_ * c + 8.0 * m_ * s * c,
            .ddsecond = -alpha_ * s + 8.0 * m_ * s * c};
  }

  [[nodiscard]] Factor factor(double angle) const {
    const double s = std::sin(angle), c = std::cos(angle);
    return {.nu = alpha_ - 2.0 * m_ * (s * s * s + c * c * c),
            .dnu = -6.0 * m_ * s * c * (s - c),
            .ddnu = -6.0 * m_ * ((c * c - s * s) * (s - c) + s * c * (c + s))};
  }

 private:
  /// Sine, cosine and u = 1 - sin, v = sin + cos - 1, w = 1 - cos (Eq. (14)), through half angles: the
  /// differences would lose all digits at the ends.
  struct At {
    explicit At(double angle) : s(std::sin(angle)), c(std::cos(angle)) {
      const double x = std::sin(angle / 2.0), y = std::sin((last - angle) / 2.0);
      u = 2.0 * y * y;
      v = 2.0 * std::numbers::sqrt2 * x * y;
      w = 2.0 * x * x;
    }
    double s, c, u, v, w;
  };

  double alpha_, m_;
};

}  // namespace kappabench::kappa
