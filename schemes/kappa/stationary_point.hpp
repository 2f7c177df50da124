#pragma once

#include <cmath>

#include "schemes/curve/vec.hpp"
#include "schemes/kappa/basis.hpp"
#include "schemes/numerics/bracketed_newton.hpp"

namespace kappabench::kappa {

/// Which vectors a velocity is written in.
enum class Velocity {
  eliminated,  ///< w c' = V in X = c_0 - p and Y = c_2 - p, c_1 being what makes c(t) = p (Miura 2022, Eq. (6))
  of_legs      ///< c' in the legs r = c_1 - c_0 and s = c_2 - c_1 of a given segment
};

/// Where |kappa| is stationary: with v the velocity in the vectors A and B,
///   K(t) = nu' |v|^2 - 3 nu v . v',
/// which has the sign of d|kappa|/dt. K is a quadratic form of A and B, so three scalar products are kept.
///
/// `eliminated`: K is positive at the start and negative at the end unless X or Y vanishes, so there is a root;
/// that it is the only one is known by experiment. It is a multiple of the degree-9 polynomial of Miura 2022,
/// Section 3.1, with the factor that vanishes at both ends divided out.
/// `of_legs`: the polynomial bases have at most one root, a peak; the trigonometric one may have more.
///
/// `softness` > 0 adds a barrier that keeps the root inside: K t (last - t) + softness (last - 2 t) nu |v|^2.
template <class Basis, Velocity velocity>
class StationaryEquation {
 public:
  StationaryEquation(const Basis& basis, const Vec2& a, const Vec2& b, double softness)
      : basis_(basis), aa_(a.squaredNorm()), ab_(a.dot(b)), bb_(b.squaredNorm()), softness_(softness) {}

  [[nodiscard]] ValueAndSlope operator()(double t) const {
    const Pair v = pair(basis_, t);
    const Factor n = basis_.factor(t);
    const double vv = product(v.first, v.second, v.first, v.second);
    const double vw = product(v.first, v.second, v.dfirst, v.dsecond);
    const double ww = product(v.dfirst, v.dsecond, v.dfirst, v.dsecond);
    const double vz = product(v.first, v.second, v.ddfirst, v.ddsecond);
    const double k = n.dnu * vv - 3.0 * n.nu * vw;
    const double dk = n.ddnu * vv - n.dnu * vw - 3.0 * n.nu * (ww + vz);
    if (softness_ == 0.0) return {k, dk};
    const double u = Basis::last - t;
    return {k * t * u + softness_ * (u - t) * n.nu * vv,
            dk * t * u + k * (u - t) + softness_ * ((u - t) * (n.dnu * vv + 2.0 * n.nu * vw) - 2.0 * n.nu * vv)};
  }

  /// The root of a function that is positive at the start and negative at the end.
  [[nodiscard]] double inner_root() const {
    // Exact for a = 2/3, `eliminated` and A orthogonal to B.
    const double a = std::cbrt(aa_), b = std::cbrt(bb_);
    return falling_root_in(*this, 0.0, Basis::last, Basis::last * a / (a + b), Bisect::where_newton_leaves);
  }

  /// Where |kappa| peaks on the closed segment: 0 or `last` where it falls or rises throughout.
  [[nodiscard]] double peak() const {
    if (softness_ == 0.0) {
      const bool rises_first = (*this)(0.0).value > 0.0, falls_last = (*this)(Basis::last).value < 0.0;
      if (!rises_first && falls_last) return 0.0;
      if (rises_first && !falls_last) return Basis::last;
      if (!rises_first) return aa_ <= bb_ ? 0.0 : Basis::last;  // a valley between two peaks at the ends
    }
    return inner_root();
  }

  /// Gradients of the function at t with respect to A and B.
  struct Gradient {
    Vec2 a, b;
  };
  [[nodiscard]] Gradient gradient(double t, const Vec2& a, const Vec2& b) const {
    const Pair p = pair(basis_, t);
    const Factor n = basis_.factor(t);
    const Vec2 v = p.first * a + p.second * b, w = p.dfirst * a + p.dsecond * b;
    const auto along = [&](double f, double df) -> Vec2 {
      const Vec2 k = (2.0 * n.dnu * f - 3.0 * n.nu * df) * v - 3.0 * n.nu * f * w;
      if (softness_ == 0.0) return k;
      const double u = Basis::last - t;
      return k * t * u + softness_ * (u - t) * 2.0 * n.nu * f * v;
    };
    return {along(p.first, p.dfirst), along(p.second, p.dsecond)};
  }

 private:
  [[nodiscard]] static Pair pair(const Basis& basis, double t) {
    if constexpr (velocity == Velocity::eliminated)
      return basis.pencil(t);
    else
      return basis.legs(t);
  }
  [[nodiscard]] double product(double p0, double p1, double q0, double q1) const {
    return p0 * q0 * aa_ + (p0 * q1 + p1 * q0) * ab_ + p1 * q1 * bb_;
  }

  Basis basis_;
  double aa_, ab_, bb_, softness_;
};

}  // namespace kappabench::kappa
