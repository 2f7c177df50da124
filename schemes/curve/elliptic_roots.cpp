#include "schemes/curve/elliptic_roots.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace kappabench {
namespace {

/// Holds the products of doubles below exactly, unless they differ by 2^220, and then there is no cancellation.
using Digits = boost::multiprecision::cpp_bin_float_100;

constexpr double rounding = 8.0 * 0x1p-52;

/// With c' = (b cos w - a sin w) dw/dt, |c'|^2 = mean - amplitude cos(2 w - phase), up to a factor: extreme where
/// 2 w - phase is a multiple of pi, least where it is an even one. kappa = a x b / |c'|^3.
struct Speed {
  Digits twice_cosine, twice_sine;  ///< amplitude times cosine and sine of the phase, twice

  explicit Speed(const EllipticArcForm& form) {
    const Digits ax = form.axis_a.x(), ay = form.axis_a.y(), bx = form.axis_b.x(), by = form.axis_b.y();
    twice_cosine = (ax * ax + ay * ay) - (bx * bx + by * by);
    twice_sine = 2 * (ax * bx + ay * by);
  }
};

bool finite(const EllipticArcForm& form) {
  return form.axis_a.allFinite() && form.axis_b.allFinite() && std::isfinite(form.from) && std::isfinite(form.to);
}

/// Whether an end is at an extremum exactly. By Lindemann's theorem tan 2w is transcendental for every double w but 0,
/// while the tangent of the phase is rational: elsewhere a hundred digits always tell the end from the extremum.
bool extreme_at(const Speed& speed, double w) {
  return w == 0.0 ? speed.twice_sine == 0 : speed.twice_sine == 0 && speed.twice_cosine == 0;
}

/// The extrema of the speed strictly between both ends: all, or only the minima.
SignChanges speed_extrema(const EllipticArcForm& form, bool minima_only) {
  SignChanges result;
  const Speed speed(form);
  const auto& pi = boost::math::constants::pi<Digits>();
  const Digits phase = atan2(speed.twice_sine, speed.twice_cosine);
  const auto turns_at = [&](double w) -> Digits { return (2 * Digits(w) - phase) / pi; };
  const auto [low, high] = std::minmax(form.from, form.to);
  const Digits first = turns_at(low), last = turns_at(high);
  for (const auto& [turns, w] : {std::pair{first, low}, std::pair{last, high}}) {
    const bool open = abs(turns - round(turns)) < Digits(1e-60) * (1 + abs(turns));
    if (open && !extreme_at(speed, w)) result.certification = Certification::enclosed;
  }
  const Digits slack = Digits(1e-60);
  for (Digits k = ceil(first + slack * (1 + abs(first))); k <= last - slack * (1 + abs(last)); k += 1) {
    if (minima_only && fmod(k, 2) != 0) continue;
    const Digits t = ((k * pi + phase) / 2 - form.from) / (Digits(form.to) - form.from);
    const auto nearest = t.convert_to<double>();
    result.at.push_back({std::nextafter(nearest, 0.0), std::min(1.0, std::nextafter(nearest, 2.0))});
  }
  if (form.to < form.from) std::reverse(result.at.begin(), result.at.end());
  return result;
}

}  // namespace

SignChanges elliptic_sign_changes(const EllipticArcForm& form, bool of_slope) {
  SignChanges result;
  if (!finite(form)) return result;
  const double aa = form.axis_a.squaredNorm(), bb = form.axis_b.squaredNorm(), ab = form.axis_a.dot(form.axis_b);
  const bool straight = std::abs(cross(form.axis_a, form.axis_b)) <= rounding * std::sqrt(aa) * std::sqrt(bb);
  const bool circular = std::hypot(0.5 * (aa - bb), ab) <= rounding * (aa + bb);
  result.vanishes = straight || (of_slope && circular) || form.from == form.to;
  return result.vanishes || !of_slope ? result : speed_extrema(form, false);
}

SignChanges elliptic_slow_places(const EllipticArcForm& form) {
  return finite(form) && form.from != form.to ? speed_extrema(form, true) : SignChanges{};
}

}  // namespace kappabench
