#include "metrics/fairness.hpp"

#include <cmath>
#include <limits>

#include "metrics/angle_turned.hpp"
#include "metrics/arc_map.hpp"
#include "metrics/arc_samples.hpp"
#include "metrics/curvature_profile.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {
namespace {

/// Is there a cusp, or a segment at rest at an end where its curvature diverges?
bool diverges(const Curve& curve, const CurvatureProfile& profile, const ArcMap& arcs) {
  for (int i = 0; i < curve.size(); ++i) {
    const double length = arcs.segment_length(i);
    if (profile.cusp_within(i, 0.0, 1.0) || diverges_at_end(curve.segment(i), 0.0, length) ||
        diverges_at_end(curve.segment(i), 1.0, length))
      return true;
  }
  return false;
}

struct Energies {
  Estimate bending;
  Estimate variation;  ///< of (d kappa / ds)^2
};

Energies energies_of(const Curve& curve, const CurvatureProfile& profile) {
  Energies sum;
  for (int i = 0; i < curve.size(); ++i) {
    std::vector<double> splits = profile.splits(i);
    for (const RootBracket& bracket : inflections(curve.segment(i)).at) splits.push_back(bracket.mid());
    const ArcQuadrature over = arc_quadrature(curve.segment(i), 0.0, 1.0, splits);
    sum.bending += over.bending;
    sum.variation += over.variation;
  }
  return sum;
}

double total_turning_of(const Curve& curve, const ArcMap& arcs) {
  double turned = 0.0;
  for (int i = 0; i < curve.size(); ++i)
    if (arcs.segment_length(i) > 0.0) turned += angle_turned(curve.segment(i), arcs.segment_length(i));
  return turned;
}

/// From the profile alone: exact, with the jumps at joints.
double total_variation(const CurvatureProfile& profile, bool closed) {
  double sum = 0.0;
  const std::size_t n = profile.points.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    sum += std::abs(profile.points[(i + 1) % n].curvature - profile.points[i].curvature);
  }
  return sum;
}

double chord_length(const Input& input) {
  double sum = 0.0;
  const std::size_t n = input.points.size();
  for (std::size_t i = 0; i + (input.closed ? 0 : 1) < n; ++i)
    sum += (input.points[(i + 1) % n] - input.points[i]).norm();
  return sum;
}

}  // namespace

Metric fairness_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const CurvatureProfile profile = curvature_profile(curve, rounding_of(fit.input));
    const ArcMap arcs(curve);
    const double length = arcs.accurate() ? arcs.length() : undefined;
    double bending = std::numeric_limits<double>::infinity();
    double mvc = bending;
    double variation = bending;
    if (!diverges(curve, profile, arcs)) {
      const Energies energies = energies_of(curve, profile);
      bending = energies.bending.to_accuracy() * length;
      mvc = energies.variation.to_accuracy() * length * length * length;
      variation = total_variation(profile, curve.closed()) * length;
    }
    using enum Method;
    return std::vector<Measurement>{column::bending_energy(bending, sampled), column::mvc_energy(mvc, sampled),
                                    // The variation is that of the extrema, but the length is quadrature.
                                    column::curvature_variation(variation, sampled),
                                    column::total_turning(total_turning_of(curve, arcs), sampled),
                                    column::length_over_chords(length / chord_length(fit.input), sampled)};
  };
  using namespace column;
  return {.id = "fairness",
          .title = "Fairness energies, free of scale",
          .version = 3,
          .columns = {bending_energy, mvc_energy, curvature_variation, total_turning, length_over_chords},
          .measure = measure};
}

}  // namespace kappabench
