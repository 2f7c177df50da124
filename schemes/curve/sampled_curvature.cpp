#include "schemes/curve/sampled_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace kappabench {
namespace {

constexpr std::size_t fewest_steps = 256;

/// Equal steps; on a sampled segment as many of them between any two samples.
std::vector<double> parameters_of(const Segment& segment) {
  const ExactForm form = segment.exact();
  const auto* sampled = std::get_if<SampledForm>(&form);
  const std::vector<double> ends = sampled == nullptr ? std::vector<double>{0.0, 1.0} : sampled->t;
  const std::size_t spans = ends.size() - 1, steps = (fewest_steps + spans - 1) / spans;
  std::vector<double> t;
  t.reserve(spans * steps + 1);
  for (std::size_t i = 0; i < spans; ++i)
    for (std::size_t j = 0; j < steps; ++j)
      t.push_back(ends[i] + (ends[i + 1] - ends[i]) * static_cast<double>(j) / static_cast<double>(steps));
  t.push_back(1.0);
  return t;
}

double mean_speed(std::span<const Jet> jets) {
  double sum = 0.0;
  for (const Jet& jet : jets) sum += speed(jet);
  return sum / static_cast<double>(jets.size());
}

std::vector<Jet> sample(const Segment& segment, std::span<const double> t, int order) {
  std::vector<Jet> jets(t.size());
  segment.jets(t, order, jets);
  return jets;
}

/// d kappa / dt, or kappa over the length of the segment; noise is 1e-9 of the largest curvature or of 1 / length.
double sampled_value(const Jet& jet, bool of_slope) {
  return of_slope ? curvature_derivative(jet) * speed(jet) : curvature(jet);
}

}  // namespace

SignChanges sampled_sign_changes(const Segment& segment, bool of_slope) {
  const int order = of_slope ? 3 : 2;
  const std::vector<double> parameters = parameters_of(segment);
  const std::vector<Jet> jets = sample(segment, parameters, order);
  const double length = mean_speed(jets);
  SignChanges result{{}, Certification::sampled, true};
  if (!(length > 0.0) || !std::isfinite(length)) return result;
  double largest = 1.0 / length;
  for (const Jet& jet : jets) {
    const double kappa = std::abs(curvature(jet));
    if (std::isfinite(kappa)) largest = std::max(largest, kappa);
  }
  const double noise = 1e-9 * largest;
  int sign_before = 0;
  double t_before = 0.0;
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const double value = sampled_value(jets[i], of_slope);
    if (!(std::abs(value) > noise)) continue;
    const int sign = value > 0.0 ? 1 : -1;
    const double t = parameters[i];
    if (sign_before != 0 && sign != sign_before) {
      RootBracket bracket{t_before, t};
      while (bracket.hi - bracket.lo > 1e-15) {
        const double mid = bracket.mid();
        const double at_mid = sampled_value(segment.jet(mid, order), of_slope);
        if (!(mid > bracket.lo && mid < bracket.hi) || std::isnan(at_mid)) break;
        ((at_mid > 0.0) == (sign_before > 0) ? bracket.lo : bracket.hi) = mid;
      }
      result.at.push_back(bracket);
    }
    sign_before = sign;
    t_before = t;
    result.vanishes = false;
  }
  return result;
}

std::vector<double> sampled_slow_places(const Segment& segment) {
  const std::vector<double> parameters = parameters_of(segment);
  const std::vector<Jet> jets = sample(segment, parameters, 2);
  const auto slowing = [&](const Jet& jet) { return jet.d[1].dot(jet.d[2]) < 0.0; };
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < jets.size(); ++i) {
    if (!slowing(jets[i]) || slowing(jets[i + 1])) continue;
    double lo = parameters[i];
    double hi = parameters[i + 1];
    while (hi - lo > 1e-15) {
      const double mid = 0.5 * (lo + hi);
      if (mid <= lo || mid >= hi) break;
      (slowing(segment.jet(mid, 2)) ? lo : hi) = mid;
    }
    const double t = 0.5 * (lo + hi);
    if (t > 0.0 && t < 1.0) found.push_back(t);
  }
  return found;
}

double mean_speed(const Segment& segment) { return mean_speed(sample(segment, parameters_of(segment), 1)); }

}  // namespace kappabench
