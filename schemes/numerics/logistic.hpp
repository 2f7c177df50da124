#pragma once

#include <cmath>

namespace kappabench {

// Both for doubles and for numbers that carry derivatives, compared by their values.

/// 1 / (1 + exp(-x)), with full relative precision on both sides; that of -x is what it lacks to 1.
template <class T>
[[nodiscard]] T logistic(const T& x) {
  using std::exp;
  if (x >= T(0.0)) return 1.0 / (1.0 + exp(-x));
  const T e = exp(x);
  return e / (1.0 + e);
}

/// log(1 + exp(x)) without overflow.
template <class T>
[[nodiscard]] T softplus(const T& x) {
  using std::exp, std::log1p;
  return x > T(0.0) ? x + log1p(exp(-x)) : log1p(exp(x));
}

}  // namespace kappabench
