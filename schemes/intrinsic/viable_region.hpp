#pragma once

#include "schemes/intrinsic/hermite_data.hpp"

namespace kappabench::intrinsic {

/// Whether G2 data have a solution of monotone curvature: the osculating circles at both ends must nest (Kneser), which
/// is Yoshida 2022, Eq. (12) with the factor kappa_s that is missing there. Curvature rises where
/// turning > 2 chord_angle; otherwise it falls, and the numbers below are those of the mirrored data.
struct Viability {
  bool rising;
  double start_slack;    ///< X = 2 sin(chord_angle) - start curvature: the start turns less than the circle to the end
  double end_slack;      ///< Y = end curvature - 2 sin(end_angle)
  double least_product;  ///< D = 4 sin^2((turning - 2 chord_angle) / 2); X Y must exceed it
  double nesting;        ///< xi = X Y / D; the circles touch at 1. NaN where D = 0

  /// D = 0 leaves the circular arc and nothing else.
  [[nodiscard]] bool only_circle() const { return least_product == 0.0; }
  [[nodiscard]] bool viable() const { return start_slack > 0.0 && end_slack > 0.0 && nesting > 1.0; }
};

/// Of data with both curvatures.
[[nodiscard]] Viability viability(const StandardData& data);

/// What is wrong with data that are not viable, in one line.
[[nodiscard]] std::string reason_not_viable(const Viability& viability);

/// The border of the region as a function of the start curvature (times the chord), for rising curvature: the end
/// curvature must exceed it. The corrected Eq. (12); infinite where the start curvature is too large for any.
[[nodiscard]] double least_end_curvature(double chord_angle, double turning, double start_curvature);

}  // namespace kappabench::intrinsic
