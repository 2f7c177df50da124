#pragma once

#include <optional>
#include <string>

#include "schemes/api/fit.hpp"
#include "schemes/intrinsic/controls.hpp"
#include "schemes/intrinsic/hermite_data.hpp"

namespace kappabench::intrinsic {

enum class Method { newton, simplex };

/// How Hermite data are met.
struct Settings {
  /// Between given curvatures the monotone family with its own knots; everything below is for data without them, or
  /// if this is false.
  bool automatic = true;
  BSplineBasis basis = uniform_basis(3, 6);
  double p = 0.0;  ///< Yoshida 2022, Eq. (11), in [-1, 1]
  Method method = Method::newton;
};

enum class Trend { constant, rising, falling, not_monotone };

/// What curvature does along the curve.
struct Verdict {
  Trend trend;
  int extrema;  ///< of curvature inside
};

/// Exact root isolation on the B-spline; where neighbouring controls differ by less than 1e-12 of the largest, which is
/// the solver's rounding, they are taken as equal.
[[nodiscard]] Verdict verdict_of(const StandardCurve& curve);

struct HermiteFit {
  Outcome outcome;
  std::string message;  ///< one line; empty when converged
  std::optional<StandardCurve> curve;
  int iterations = 0;     ///< Newton steps, or evaluations of the simplex
  double residual = 0.0;  ///< `gap` of the curve
};

/// A curve through both ends with their headings, and with those of the two curvatures that are given. Curvatures free
/// at both ends: unknowns are the first and last control (G1); given ones are first and last control, and the unknowns
/// their neighbours (G2). With `automatic`, two given curvatures have a monotone solution exactly if the data are
/// viable; if they are not the outcome is `unsupported_input` with the reason, and there is no curve. One given
/// curvature is completed by one that makes the data viable, if there is any. Otherwise the curve may have extrema:
/// `verdict_of` tells. Never throws for finite data and a well-formed basis.
[[nodiscard]] HermiteFit solve(const StandardData& data, const Settings& settings = {});

/// The rule that `solve` uses on fixed knots: given end curvatures are controls of their own, and the unknowns are the
/// first and last of the others. Needs two controls more than there are given curvatures.
[[nodiscard]] ControlRule rule_for(const StandardData& data, const BSplineBasis& basis, double p);

/// The fit that a solver's curve makes: it counts only if its gap, measured anew, is closed to rounding.
[[nodiscard]] HermiteFit judged(const StandardData& data, StandardCurve curve, int iterations, bool converged);

}  // namespace kappabench::intrinsic
