#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace kappabench {

/// Explicit B-splines on [0, 1] in the notation of Yoshida 2022, Sect. 3: m coefficients of degree n have m + n - 1
/// knots t_1 <= ... <= t_{m+n-1}, that is, without the outermost pair that some texts repeat; they are clamped: the
/// first n are 0, the last n are 1.
struct BSplineBasis {
  int degree;                 ///< n, 1 to 9
  std::vector<double> knots;  ///< m + n - 1 of them

  [[nodiscard]] int size() const { return static_cast<int>(knots.size()) - degree + 1; }  ///< m
};

/// Why these are not the knots of such a basis, in one line; empty if they are. An inner knot may be repeated up to n
/// times: n times it is a corner of the function.
[[nodiscard]] std::string reason_ill_formed(const BSplineBasis& basis);

/// `size` > `degree` coefficients whose inner knots are equally spaced.
[[nodiscard]] BSplineBasis uniform_basis(int degree, int size);

/// Where each coefficient acts: the mean of n consecutive knots (Yoshida 2022, Eq. (4)). Ascending from 0 to 1.
[[nodiscard]] std::vector<double> greville_abscissae(const BSplineBasis& basis);

/// The integrals over [0, 1] of the basis functions, (t_{i+n} - t_{i-1}) / (n + 1) with the end knots repeated once
/// more; they add up to 1. The integral of Yoshida 2022, Eq. (8), is their product with the coefficients.
[[nodiscard]] std::vector<double> basis_integrals(const BSplineBasis& basis);

/// A knot span of positive width.
struct KnotSpan {
  double from, to;
  int first;                     ///< its function depends on the coefficients first to first + n
  Eigen::MatrixXd to_bernstein;  ///< (n + 1) x (n + 1): from those coefficients to the Bernstein ones of the span

  [[nodiscard]] double width() const { return to - from; }
};

[[nodiscard]] std::vector<KnotSpan> spans_of(const BSplineBasis& basis);

}  // namespace kappabench
