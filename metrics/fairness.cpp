#include "metrics/fairness.hpp"

#include <cmath>
#include <limits>

#include "metrics/angle_turned.hpp"
#include "metrics/arc_samples.hpp"
#include "metrics/curvature_profile.hpp"
#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {
namespace {

struct Integrals {
  Estimate length;
  Estimate bending;
  Estimate variation;  ///< of (d kappa / ds)^2
  double turning = 0.0;
  bool diverges = false;
};

Integrals integrate(const Curve& curve, const CurvatureProfile& profile) {
  Integrals sum;
  for (int i = 0; i < curve.size(); ++i) {
    const Segment& segment = curve.segment(i);
    std::vector<double> splits = profile.splits(i);
    for (const RootBracket& bracket : inflections(segment).at) splits.push_back(bracket.mid());
    const ArcQuadrature over = arc_quadrature(segment, 0.0, 1.0, splits);
    const double length = over.length.value;
    sum.length += over.length;
    sum.bending += over.bending;
    sum.variation += over.variation;
    if (!(length > 0.0)) continue;
    sum.turning += angle_turned(segment, length);
    sum.diverges = sum.diverges || profile.cusp_within(i, 0.0, 1.0) || diverges_at_end(segment, 0.0, length) ||
                   diverges_at_end(segment, 1.0, length);
  }
  return sum;
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
    const CurvatureProfile profile = curvature_profile(curve);
    const Integrals sum = integrate(curve, profile);
    const double length = sum.length.to_accuracy();
    const auto finite_or_divergent = [&](double value) {
      return sum.diverges ? std::numeric_limits<double>::infinity() : value;
    };
    using enum Method;
    return std::vector<Measurement>{
        column::bending_energy(finite_or_divergent(sum.bending.to_accuracy() * length), sampled),
        column::mvc_energy(finite_or_divergent(sum.variation.to_accuracy() * length * length * length), sampled),
        // The variation is that of the extrema, but the length is quadrature.
        column::curvature_variation(finite_or_divergent(total_variation(profile, curve.closed()) * length), sampled),
        column::total_turning(sum.turning, sampled),
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
