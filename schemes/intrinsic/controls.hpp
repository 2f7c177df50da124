#pragma once

#include <Eigen/Core>

#include "schemes/numerics/bspline.hpp"

namespace kappabench::intrinsic {

/// Which control curvatures are solved for and what the others follow from (Yoshida 2022, Fig. 2): with the two
/// unknowns x and y, control i is first[i] x + last[i] y + fixed[i]. Fixed values are times the chord.
struct ControlRule {
  Eigen::VectorXd first;
  Eigen::VectorXd last;
  Eigen::VectorXd fixed;

  [[nodiscard]] Eigen::VectorXd controls(double x, double y) const { return first * x + last * y + fixed; }
  /// Nothing is prescribed: the length is then found after the shape.
  [[nodiscard]] bool free_of_scale() const { return fixed.isZero(0.0); }
};

/// x = kappa_{i1}, y = kappa_{im} (counted from 0), the controls between them by Yoshida 2022, Eqs. (10), (11) with p
/// in
/// [-1, 1], over Greville abscissae throughout; those outside are zero until `fix` says what they are. Needs
/// 0 <= i1 < im < size. p = 0 is the straight line from x to y, p = 1 has x everywhere up to y, p = -1 y from x on.
[[nodiscard]] ControlRule interpolated(const BSplineBasis& basis, int i1, int im, double p);

/// The control is no longer part of the rule but has this value, times the chord.
void fix(ControlRule& rule, int i, double value);

/// The control follows another one, as in Yoshida 2022, Fig. 3(f), where both end pairs are equal.
void tie(ControlRule& rule, int i, int to);

}  // namespace kappabench::intrinsic
