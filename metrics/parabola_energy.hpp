#pragma once

#include <optional>
#include <span>
#include <string>

#include "metrics/metric.hpp"
#include "schemes/curve/segment.hpp"

namespace kappabench {

/// How far curvature is from a parabola: E_p = integral of (kappa - Q)^2 ds (Wang 2024, Eq. (3)), 1/length.

/// Of one way to cut the curve into pieces and to choose Q.
struct ParabolaEnergyColumns {
  Column mean, max, scaled_mean, scaled_max;  ///< scaled: times the mean chord
};

namespace column {
[[nodiscard]] ParabolaEnergyColumns parabola_energy(const std::string& variant, const std::string& what);

inline const ParabolaEnergyColumns parabola_energy_native =
    parabola_energy("native", "segments with one node inside, parabola in t with its vertex at the node");
inline const ParabolaEnergyColumns parabola_energy_native_free =
    parabola_energy("native_free", "segments with one node inside, any parabola in t");
inline const ParabolaEnergyColumns parabola_energy_centred = parabola_energy(
    "centred", "midpoint to midpoint around each node, parabola in arc length with its vertex at the node");
inline const ParabolaEnergyColumns parabola_energy_centred_free =
    parabola_energy("centred_free", "midpoint to midpoint around each node, any parabola in arc length");
}  // namespace column

/// Q(u) = a0 + a1 u + a2 u^2.
struct Parabola {
  double a0;
  double a1;
  double a2;

  [[nodiscard]] double operator()(double u) const { return a0 + u * (a1 + u * a2); }
};

/// Curvature at a parameter u of a piece, and ds there.
struct CurvatureSample {
  double u;
  double curvature;
  double weight;
};

struct ParabolaFit {
  Parabola parabola;
  double energy;
};

/// The parabola of least energy over the samples, by weighted linear least squares (Householder QR); with `vertex`
/// among those whose vertex is there: Q = b + a (u - vertex)^2. Needs a sample.
[[nodiscard]] ParabolaFit fit_parabola(std::span<const CurvatureSample> samples, std::optional<double> vertex);

/// E_p of a whole segment for a given parabola in its parameter t. Infinite at a cusp.
[[nodiscard]] double parabola_energy(const Segment& segment, const Parabola& parabola);

/// E_p of a whole segment for the best parabola in t, with its vertex at `vertex` if that is given. Infinite at a cusp.
[[nodiscard]] ParabolaFit best_parabola(const Segment& segment, std::optional<double> vertex);

/// Columns parabola_energy_{native,native_free,centred,centred_free}_{mean,max,scaled_mean,scaled_max}.
[[nodiscard]] Metric parabola_energy_metric();

}  // namespace kappabench
