#pragma once

#include "schemes/intrinsic/angle_table.hpp"
#include "schemes/intrinsic/controls.hpp"
#include "schemes/intrinsic/hermite_data.hpp"
#include "schemes/numerics/damped_newton.hpp"

namespace kappabench::intrinsic {

/// What a solver of two unknown control curvatures and the length ends with.
struct Solved {
  double x, y;    ///< the unknowns of the ControlRule, times the chord
  double length;  ///< over the chord
  int iterations;
  double residual;  ///< of the equations: radians and chords
  bool converged;
};

/// Hermite interpolation on fixed knots in dimensionless form: controls times length are the unknowns, the turning is
/// linear in them, and nothing is divided by it, so that S-shaped data are like any other (Eq. (8) of Yoshida 2022 is
/// 0/0 there). Set up once for a basis and a rule, then used for any data.
///
/// Without fixed controls this is one equation, the end's distance from the chord's line, by Newton with the analytic
/// derivative; the length follows. With fixed ones there are three: turning, and both coordinates of the end. Both
/// start from the solution of the linearised problem, and where Newton fails from there all angles and fixed
/// curvatures grow from zero together. Reads the data's angles; what curvatures they ask for is the rule's.
class FixedKnots {
 public:
  FixedKnots(const BSplineBasis& basis, ControlRule rule);

  [[nodiscard]] Solved solve(const StandardData& data) const;

  /// Both unknowns of the problem for small angles, where the end's place is linear in them: length 1.
  [[nodiscard]] Eigen::Vector2d linearised(const StandardData& data) const;

  [[nodiscard]] StandardCurve curve(const Solved& solved) const;

  /// The rule at the nodes of the quadrature for curves that turn by less than 2.5 rad.
  [[nodiscard]] const RuleTable& table() const { return coarse_; }

 private:
  /// With the solution of another quadrature to start `near`, if there is one.
  [[nodiscard]] Solved solve_free(const RuleTable& rule, const StandardData& data, const Solved* near) const;
  [[nodiscard]] Solved solve_fixed(const RuleTable& rule, const StandardData& data, const Solved* near) const;
  [[nodiscard]] double absolute_turning(const Solved& solved) const;

  BSplineBasis basis_;
  ControlRule rule_;
  Eigen::VectorXd integrals_;  ///< of the basis functions
  RuleTable coarse_, fine_;    ///< for curves that turn by less than 2.5 and 8 rad
};

/// The three equations where some control is fixed, by x, y and the logarithm of the length, with the data's angles and
/// the fixed values times `share`: turning (radians), and the end against its place on the chord (across, along).
[[nodiscard]] ThreeEquations fixed_equations(const RuleTable& rule, const StandardData& data, double share,
                                             const Eigen::Vector3d& unknowns);

/// The G1 clothoid of the data's angles, curvature linear from x to y: its table is set up once.
[[nodiscard]] Solved g1_clothoid(const StandardData& data);

}  // namespace kappabench::intrinsic
