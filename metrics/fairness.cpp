#include "metrics/fairness.hpp"

#include <cmath>

#include "metrics/arc_samples.hpp"
#include "metrics/curvature_profile.hpp"
#include "metrics/statistics.hpp"
#include "schemes/curve/exact_curvature.hpp"

namespace kappabench {
namespace {

struct Integrals {
  double length = 0.0;
  double bending = 0.0;
  double variation = 0.0;  ///< of (d kappa / ds)^2
  double turning = 0.0;
  bool cusp = false;
};

Integrals integrate(const Curve& curve, const CurvatureProfile& profile) {
  Integrals sum;
  for (int i = 0; i < curve.size(); ++i) {
    std::vector<double> splits = profile.splits(i);
    for (const RootBracket& bracket : inflections(curve.segment(i)).at) splits.push_back(bracket.mid());
    for (const ArcSample& sample : arc_samples(curve.segment(i), 0.0, 1.0, splits)) {
      sum.length += sample.weight;
      sum.bending += sample.weight * sample.curvature * sample.curvature;
      sum.variation += sample.weight * sample.rate * sample.rate;
      sum.turning += sample.weight * std::abs(sample.curvature);
    }
    sum.cusp = sum.cusp || profile.cusp_within(i, 0.0, 1.0);
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
  const std::string infinite = "; infinite with a cusp";
  const std::vector<Column> columns{
      {"bending_energy", "1", "integral of kappa^2 ds times length" + infinite},
      {"mvc_energy", "1", "integral of (d kappa / ds)^2 ds over the segments times length^3" + infinite},
      {"curvature_variation", "1", "total variation of curvature, jumps at joints included, times length" + infinite},
      {"total_turning", "rad", "integral of |kappa| ds, without the corners at joints and cusps"},
      {"length_over_chords", "1", "length of the curve over that of the polygon of the points"}};

  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const CurvatureProfile profile = curvature_profile(curve);
    const Integrals sum = integrate(curve, profile);
    const double divergent = std::numeric_limits<double>::infinity();
    const double length = sum.length;
    const Method variation_method = profile.certified ? Method::exact : Method::sampled;
    const auto finite_or_divergent = [&](double value) { return sum.cusp ? divergent : value; };
    return std::vector<Measurement>{
        {"bending_energy", finite_or_divergent(sum.bending * length), Method::sampled},
        {"mvc_energy", finite_or_divergent(sum.variation * length * length * length), Method::sampled},
        {"curvature_variation", finite_or_divergent(total_variation(profile, curve.closed()) * length),
         variation_method},
        {"total_turning", sum.turning, Method::sampled},
        {"length_over_chords", length / chord_length(fit.input), Method::sampled}};
  };
  return {"fairness", "Fairness energies, free of scale", 1, columns, measure};
}

}  // namespace kappabench
