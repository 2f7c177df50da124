#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace kappabench {

/// The first `Count` Taylor coefficients f^(k) / k! of a function of one variable; with intervals for numbers, of the
/// function about every place of an interval. Arithmetic is that of truncated power series (Moore 1966, ch. 11).
template <class Number, std::size_t Count>
using TaylorSeries = std::array<Number, Count>;

template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> sum(TaylorSeries<Number, Count> f, const TaylorSeries<Number, Count>& g) {
  for (std::size_t k = 0; k < Count; ++k) f[k] += g[k];
  return f;
}

template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> difference(TaylorSeries<Number, Count> f,
                                                     const TaylorSeries<Number, Count>& g) {
  for (std::size_t k = 0; k < Count; ++k) f[k] -= g[k];
  return f;
}

/// factor * f + constant.
template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> affine(const Number& factor, TaylorSeries<Number, Count> f,
                                                 const Number& constant) {
  for (Number& coefficient : f) coefficient *= factor;
  f[0] += constant;
  return f;
}

template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> product(const TaylorSeries<Number, Count>& f,
                                                  const TaylorSeries<Number, Count>& g) {
  TaylorSeries<Number, Count> result;
  for (std::size_t k = 0; k < Count; ++k) {
    result[k] = f[0] * g[k];
    for (std::size_t j = 1; j <= k; ++j) result[k] += f[j] * g[k - j];
  }
  return result;
}

template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> quotient(const TaylorSeries<Number, Count>& f,
                                                   const TaylorSeries<Number, Count>& g) {
  TaylorSeries<Number, Count> result;
  for (std::size_t k = 0; k < Count; ++k) {
    Number rest = f[k];
    for (std::size_t j = 1; j <= k; ++j) rest -= g[j] * result[k - j];
    result[k] = rest / g[0];
  }
  return result;
}

template <class Number, std::size_t Count>
struct CosineAndSine {
  TaylorSeries<Number, Count> cosine, sine;
};

/// From cos' = -sin f', sin' = cos f'.
template <class Number, std::size_t Count>
[[nodiscard]] CosineAndSine<Number, Count> cosine_and_sine(const TaylorSeries<Number, Count>& f) {
  CosineAndSine<Number, Count> result;
  auto& [cosine, sine] = result;
  cosine[0] = cos(f[0]);
  sine[0] = sin(f[0]);
  for (std::size_t k = 1; k < Count; ++k) {
    Number of_cosine(0.0), of_sine(0.0);
    for (std::size_t j = 1; j <= k; ++j) {
      const Number slope = static_cast<double>(j) * f[j];
      of_cosine -= slope * sine[k - j];
      of_sine += slope * cosine[k - j];
    }
    cosine[k] = of_cosine / static_cast<double>(k);
    sine[k] = of_sine / static_cast<double>(k);
  }
  return result;
}

/// The integral of f' (with its constant chosen): coefficient k + 1 is that of f over k + 1; the last one is dropped.
template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> integral(const TaylorSeries<Number, Count>& f, const Number& constant) {
  TaylorSeries<Number, Count> result;
  result[0] = constant;
  for (std::size_t k = 1; k < Count; ++k) result[k] = f[k - 1] / static_cast<double>(k);
  return result;
}

/// That of the derivative; its last coefficient, which f does not tell, is 0 and must not be used.
template <class Number, std::size_t Count>
[[nodiscard]] TaylorSeries<Number, Count> derivative(const TaylorSeries<Number, Count>& f) {
  TaylorSeries<Number, Count> result;
  for (std::size_t k = 0; k + 1 < Count; ++k) result[k] = static_cast<double>(k + 1) * f[k + 1];
  result[Count - 1] = Number(0.0);
  return result;
}

}  // namespace kappabench
