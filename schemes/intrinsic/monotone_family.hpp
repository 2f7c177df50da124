#pragma once

#include "schemes/intrinsic/hermite_data.hpp"
#include "schemes/numerics/damped_newton.hpp"

namespace kappabench::intrinsic {

/// Cubic B-spline curvature with 8 controls and 4 inner knots that move: three unknowns, and for any values of them the
/// curvature rises and has the given ends. It reaches from the two-level step, which is all there is on the border of
/// the viable region, over the clothoid to the flat S deep inside it, so that a G2 solution with monotone curvature is
/// one point of a smooth family instead of knots set by hand (Yoshida 2022, Sect. 5.3 and future work).
///
/// With z for where curvature rises and y for how sharply (a(y) is 1 at y = 0, grows like exp(y) and falls like
/// ln 2 / |y|), b = z sqrt(1 + a^2), zeta = z a / sqrt(1 + a^2) and sigma the logistic function:
///   logits of the inner knots    -zeta -+ o2, -zeta -+ o1, o1 = ln 1.5 / a, o2 = o1 + 2 ln(8/3) / (1 + a)
///   control i of ks + (ke - ks) C_i    C_i = w sigma(a logit(x_i) + b) + u Step_i + v Plateau_i
/// over Greville abscissae x_i, with weights w + u + v = 1 that make w all of it at a = 1, u for large and v for small
/// a. Each part is non-decreasing in i. At a = 1, z = 0 curvature is linear: the clothoid.
struct FamilyMember {
  double log_length;
  double y;
  double z;
};

/// The member, for rising curvature from `start` to `end` (times the chord).
[[nodiscard]] StandardCurve member_curve(const FamilyMember& member, double start, double end);

/// The three equations of a member and data, by log_length, y, z: turning (radians), and where the end is against its
/// place on the chord (across, along).
[[nodiscard]] ThreeEquations member_equations(const FamilyMember& member, const StandardData& data);

struct MonotoneSolution {
  StandardCurve curve;
  int iterations;
  double residual;  ///< of the equations
  bool converged;
};

/// A monotone curvature for viable G2 data (`viability`), by continuation from the clothoid of the same angles along a
/// path that is straight in log(xi - 1) and log(X / Y). Falling data are solved mirrored, data whose end curvature is
/// the larger one reversed. Converged at a residual of 2e-14, or 4e-16 of the largest curvature times the chord.
[[nodiscard]] MonotoneSolution solve_monotone(const StandardData& data);

}  // namespace kappabench::intrinsic
