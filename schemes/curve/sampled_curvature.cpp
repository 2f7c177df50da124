#include "schemes/curve/sampled_curvature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace kappabench {
namespace {

constexpr double step = 1.0 / 256.0;

double mean_speed(std::span<const Jet> jets) {
  double sum = 0.0;
  for (const Jet& jet : jets) sum += speed(jet);
  return sum / static_cast<double>(jets.size());
}

std::array<Jet, 257> sample(const Segment& segment, int order) {
  std::array<double, 257> t{};
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = static_cast<double>(i) * step;
  std::array<Jet, 257> jets;
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
  const std::array<Jet, 257> jets = sample(segment, order);
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
    const double t = static_cast<double>(i) * step;
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
  const std::array<Jet, 257> jets = sample(segment, 2);
  const auto slowing = [&](const Jet& jet) { return jet.d[1].dot(jet.d[2]) < 0.0; };
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < jets.size(); ++i) {
    if (!slowing(jets[i]) || slowing(jets[i + 1])) continue;
    double lo = static_cast<double>(i) * step;
    double hi = lo + step;
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

double mean_speed(const Segment& segment) { return mean_speed(sample(segment, 1)); }

}  // namespace kappabench
