#pragma once

#include <complex>

namespace kappabench {

/// The tail of Fresnel's integral without its oscillation, for x >= 0:
///   exp(-i x^2) * exp(-i pi/4) / sqrt(pi) * integral of exp(i u^2) du from x to infinity
/// = w(exp(i pi/4) x) / 2 with Faddeeva's function w. It falls monotonically in modulus from 1/2 at 0 to
/// 1 / (2 sqrt(pi) x) for large x.
///
/// Trapezium rule with the pole's residue added (Chandler-Wilde and Alazah 2014, Eq. (1.8)) at N = 12 nodes, for which
/// they prove an error below 1e-15, absolute and relative, on the whole axis. Valid to x = 1e150.
[[nodiscard]] std::complex<double> fresnel_tail(double x);

/// C(z) + i S(z) = integral of exp(i pi u^2 / 2) du from 0 to z, |z| <= 1e150. Error below 1e-15.
[[nodiscard]] std::complex<double> fresnel(double z);

}  // namespace kappabench
