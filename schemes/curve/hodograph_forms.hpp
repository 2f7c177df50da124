#pragma once

#include <span>

#include "schemes/numerics/binary_form.hpp"

namespace kappabench {

/// The tangent of a polynomial, rational or trigonometric segment up to a positive factor, as a pair of forms of degree
/// m: c'(t) is a positive constant times (x, y) / omega^e with a positive form omega. Then
///   kappa = constant * N * omega^e / D^(3/2),  N = x_s y_t - x_t y_s,  D = x^2 + y^2,
/// with numerator and denominator of one degree. Of such a quotient f / g^(3/2) the derivative is a positive multiple
/// of f_t g_s - f_s g_t (Euler's identity for homogeneous functions), which gives `slope` the least possible degree.
template <class Number>
struct HodographForms {
  BinaryForm<Number> x;
  BinaryForm<Number> y;
  BinaryForm<Number> omega;
  int exponent;

  /// N: changes sign where the curvature does. Degree 2m - 2.
  [[nodiscard]] BinaryForm<Number> curvature_numerator() const {
    return difference(product(partial_s(x), partial_t(y)), product(partial_t(x), partial_s(y)));
  }
  /// D. Degree 2m.
  [[nodiscard]] BinaryForm<Number> speed_squared() const { return sum(product(x, x), product(y, y)); }

  /// Changes sign where d kappa / dt does: (N_t omega + e N omega_t) D_s - (N_s omega + e N omega_s) D_t.
  [[nodiscard]] BinaryForm<Number> slope() const {
    const BinaryForm<Number> n = curvature_numerator();
    const BinaryForm<Number> d = speed_squared();
    const auto part = [&](const BinaryForm<Number>& dn, const BinaryForm<Number>& domega) {
      return sum(product(dn, omega), scaled(product(n, domega), exponent));
    };
    return difference(product(part(partial_t(n), partial_t(omega)), partial_s(d)),
                      product(part(partial_s(n), partial_s(omega)), partial_t(d)));
  }
};

/// Bézier control points, given as coordinates.
template <class Number>
[[nodiscard]] HodographForms<Number> polynomial_hodograph(std::span<const Number> px, std::span<const Number> py) {
  const int degree = static_cast<int>(px.size()) - 1;
  const auto differences = [degree](std::span<const Number> p) {
    BinaryForm<Number> form;
    int binomial = 1;
    for (int i = 0; i < degree; ++i) {
      const auto k = static_cast<std::size_t>(i);
      form.push_back((p[k + 1] - p[k]) * Number(binomial));
      binomial = binomial * (degree - 1 - i) / (i + 1);
    }
    return form;
  };
  return {differences(px), differences(py), {Number(1), Number(1)}, degree + 1};
}

/// Bézier control points with weights: c = P / omega with the forms P and omega of degree n of the weighted points and
/// of the weights, and by Euler's identity c'(t) = (P_t omega_s - P_s omega_t) / (n omega^2).
template <class Number>
[[nodiscard]] HodographForms<Number> rational_hodograph(std::span<const Number> px, std::span<const Number> py,
                                                        std::span<const Number> weights) {
  const int degree = static_cast<int>(px.size()) - 1;
  const auto form_of = [&](auto value) {
    BinaryForm<Number> form;
    int binomial = 1;
    for (int i = 0; i <= degree; ++i) {
      form.push_back(value(static_cast<std::size_t>(i)) * Number(binomial));
      binomial = binomial * (degree - i) / (i + 1);
    }
    return form;
  };
  const BinaryForm<Number> omega = form_of([&](std::size_t i) { return weights[i]; });
  const auto tangent = [&](std::span<const Number> p) {
    const BinaryForm<Number> weighted = form_of([&](std::size_t i) { return weights[i] * (p[i] - p[0]); });
    return difference(product(partial_t(weighted), partial_s(omega)), product(partial_s(weighted), partial_t(omega)));
  };
  return {tangent(px), tangent(py), omega, 2};
}

/// The quadratic trigonometric basis (Miura 2022, Eq. (17)). With x = tan(pi t / 4) as parameter it is a rational
/// quartic: c = P / omega^2, omega = 1 + x^2, P with the coefficients (1, 4, 8, 8, 4) times the control points, and
/// dc/dx = 2 (P_t omega_s - P_s omega_t) / omega^3 up to the factor of Euler's identity.
template <class Number>
[[nodiscard]] HodographForms<Number> trigonometric_hodograph(std::span<const Number> px, std::span<const Number> py) {
  const auto tangent = [](std::span<const Number> p) {
    BinaryForm<Number> form;
    int i = 0;
    for (const int weight : {1, 4, 8, 8, 4}) form.push_back((p[static_cast<std::size_t>(i++)] - p[0]) * Number(weight));
    const BinaryForm<Number> half_omega_s{Number(1), Number(1)};
    const BinaryForm<Number> half_omega_t{Number(1), Number(2)};
    return difference(product(partial_t(form), half_omega_s), product(partial_s(form), half_omega_t));
  };
  return {tangent(px), tangent(py), {Number(1), Number(2), Number(2)}, 3};
}

}  // namespace kappabench
