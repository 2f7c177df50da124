#pragma once

#include <span>
#include <vector>

#include "schemes/curve/curve.hpp"

namespace kappabench {

/// One node of a quadrature over arc length: the integral of f over the piece is the sum of weight * f(sample).
struct ArcSample {
  double t;             ///< parameter in the segment
  double s;             ///< arc length from the start of the piece
  double weight;        ///< ds
  double gauss_weight;  ///< that of the embedded Gauss rule, whose sum tells the error
  double curvature;     ///< signed
  double rate;          ///< d curvature / ds
  double rounding;      ///< bound of the rounding error of the curvature
};

/// An integral, its estimated absolute error, and what rounding alone may make of that.
struct Estimate {
  double value = 0.0;
  double error = 0.0;
  double rounding = 0.0;

  Estimate& operator+=(const Estimate& other);
  /// The value, or NaN if its error exceeds 1e-10 of it plus twice the rounding.
  [[nodiscard]] double to_accuracy() const;
};

/// The accuracy that metrics promise of quadrature.
inline constexpr double promised_accuracy = 1e-10;

/// A piece of a segment cut into panels of 15 Gauss-Kronrod samples.
struct ArcQuadrature {
  std::vector<double> bounds;      ///< of the panels, ascending
  std::vector<ArcSample> samples;  ///< 15 a panel, ascending; those without a curvature (zero speed) have no weight
  Estimate length;
  Estimate bending;    ///< integral of kappa^2 ds
  Estimate variation;  ///< integral of (d kappa / ds)^2 ds
};

/// Quadrature for smooth functions of arc length, curvature and its rate over a piece of a segment.
///
/// Method: the panels are the steady stretches of the segment, also split at `splits` (curvature extrema, inflections),
/// then bisected in rounds until length, integral of kappa^2 and integral of (d kappa / ds)^2 have an estimated
/// relative error below 1e-13 (1e-11 for the last) or below that of rounding, or 1000 panels are reached: at a cusp the
/// latter two diverge. `s` within a panel is the integral of the polynomial through its 15 speeds.
[[nodiscard]] ArcQuadrature arc_quadrature(const Segment& segment, double t0, double t1,
                                           std::span<const double> splits = {});

/// Its samples alone.
[[nodiscard]] std::vector<ArcSample> arc_samples(const Segment& segment, double t0, double t1,
                                                 std::span<const double> splits = {});

/// Is the integral of kappa^2 infinite at the end t (0 or 1) of the segment: does it rest there, and its curvature
/// diverge? With c' = a t + b t^2 + ... it is a x b / (|a|^3 t) + ...
[[nodiscard]] bool diverges_at_end(const Segment& segment, double t, double length);

}  // namespace kappabench
