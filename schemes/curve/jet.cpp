#include "schemes/curve/jet.hpp"

#include <cmath>

namespace kappabench {

// With n = c' x c'' and D = |c'|^2:  kappa = n D^(-3/2)  and  d/ds = D^(-1/2) d/dt. The derivatives below follow by
// the product rule; n' = c' x c''', n'' = c'' x c''' + c' x c'''', D' = 2 c'.c'', D'' = 2 (c''.c'' + c'.c''').

double speed(const Jet& jet) { return jet.d[1].norm(); }

double curvature(const Jet& jet) {
  const double v = speed(jet);
  return cross(jet.d[1], jet.d[2]) / (v * v * v);
}

double curvature_derivative(const Jet& jet) {
  const auto& [p, c1, c2, c3, c4] = jet.d;
  const double D = c1.squaredNorm();
  const double n = cross(c1, c2);
  const double dn = cross(c1, c3);
  const double dD = 2.0 * c1.dot(c2);
  return (dn * D - 1.5 * n * dD) / (D * D * D);
}

double curvature_second_derivative(const Jet& jet) {
  const auto& [p, c1, c2, c3, c4] = jet.d;
  const double D = c1.squaredNorm();
  const double n = cross(c1, c2);
  const double dn = cross(c1, c3);
  const double ddn = cross(c2, c3) + cross(c1, c4);
  const double dD = 2.0 * c1.dot(c2);
  const double ddD = 2.0 * (c2.squaredNorm() + c1.dot(c3));
  // d/dt of g D^-3 with g = n' D - 3/2 n D', then once more over the speed.
  const double g = dn * D - 1.5 * n * dD;
  const double dg = ddn * D - 0.5 * dn * dD - 1.5 * n * ddD;
  return (dg * D - 3.0 * g * dD) / (D * D * D * D * std::sqrt(D));
}

double tangent_angle(const Jet& jet) { return std::atan2(jet.d[1].y(), jet.d[1].x()); }

}  // namespace kappabench
