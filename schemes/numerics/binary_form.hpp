#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace kappabench {

/// A polynomial on [0, 1] of degree d as a homogeneous form in s = 1 - t and t: the coefficients a_0 ... a_d of
/// sum a_i s^(d-i) t^i, that is, Bernstein coefficients times binomials. In this form products are convolutions, all
/// constants are integers, and the number of sign changes of the coefficients bounds the roots in (0, 1) (Descartes).
/// The empty form is the zero polynomial of any degree.
template <class Number>
using BinaryForm = std::vector<Number>;

template <class Number>
[[nodiscard]] BinaryForm<Number> product(const BinaryForm<Number>& a, const BinaryForm<Number>& b) {
  if (a.empty() || b.empty()) return {};
  BinaryForm<Number> result(a.size() + b.size() - 1, Number(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

/// Both of one degree, or one of them empty.
template <class Number>
[[nodiscard]] BinaryForm<Number> sum(BinaryForm<Number> a, const BinaryForm<Number>& b) {
  if (a.empty()) return b;
  for (std::size_t i = 0; i < b.size(); ++i) a[i] = a[i] + b[i];
  return a;
}

template <class Number>
[[nodiscard]] BinaryForm<Number> difference(BinaryForm<Number> a, const BinaryForm<Number>& b) {
  if (a.empty()) a.assign(b.size(), Number(0));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] = a[i] - b[i];
  return a;
}

template <class Number>
[[nodiscard]] BinaryForm<Number> scaled(BinaryForm<Number> a, int factor) {
  for (Number& coefficient : a) coefficient = coefficient * Number(factor);
  return a;
}

/// Partial derivative in s, of one degree less.
template <class Number>
[[nodiscard]] BinaryForm<Number> partial_s(const BinaryForm<Number>& a) {
  BinaryForm<Number> result;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) result.push_back(a[i] * Number(static_cast<int>(a.size() - 1 - i)));
  return result;
}

/// Partial derivative in t, of one degree less.
template <class Number>
[[nodiscard]] BinaryForm<Number> partial_t(const BinaryForm<Number>& a) {
  BinaryForm<Number> result;
  for (std::size_t i = 1; i < a.size(); ++i) result.push_back(a[i] * Number(static_cast<int>(i)));
  return result;
}

/// The form on [0, 1/2] and on [1/2, 1], each again over [0, 1] and multiplied by 2^d. `a` is not empty.
template <class Number>
[[nodiscard]] std::pair<BinaryForm<Number>, BinaryForm<Number>> halves(const BinaryForm<Number>& a) {
  BinaryForm<Number> left = a;                        // s -> 2s + t
  BinaryForm<Number> right = a;                       // t -> s + 2t
  const std::size_t n = a.size();                     // not 0
  for (std::size_t last = n - 1; last > 0; --last) {  // Horner's scheme for s -> s + t and t -> s + t
    for (std::size_t i = 1; i <= last; ++i) {
      left[i] += left[i - 1];
      right[n - 1 - i] += right[n - i];
    }
  }
  Number power(1);
  for (std::size_t i = 0; i < n; ++i) {
    right[i] = right[i] * power;
    left[n - 1 - i] = left[n - 1 - i] * power;
    power = power * Number(2);
  }
  return {std::move(left), std::move(right)};
}

}  // namespace kappabench
