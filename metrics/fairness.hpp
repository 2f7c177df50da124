#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

namespace column {
inline const Column bending_energy{
    "bending_energy", "1",
    "integral of kappa^2 ds times length; infinite with a cusp or an end at rest where curvature diverges"};
inline const Column mvc_energy{
    "mvc_energy", "1", "integral of (d kappa / ds)^2 ds over the segments times length^3; infinite with a cusp"};
inline const Column curvature_variation{
    "curvature_variation", "1",
    "total variation of curvature, jumps at joints included, times length; infinite with a cusp"};
inline const Column total_turning{"total_turning", "rad",
                                  "integral of |kappa| ds, without the corners at joints and cusps"};
inline const Column length_over_chords{"length_over_chords", "1",
                                       "length of the curve over that of the polygon of the points"};
}  // namespace column

/// The classical fairness energies, made free of scale by powers of the curve's length. NaN where quadrature does not
/// reach 1e-10.
[[nodiscard]] Metric fairness_metric();

}  // namespace kappabench
