#include "schemes/numerics/bspline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace kappabench {

namespace {

constexpr int most_degree = 9;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The polar form of the spline at n arguments, as a row over coefficients first to first + n: `ends` of the arguments
/// are `b`, the others `a`. Coefficient i is the polar form at knots i to i + n - 1 (Ramshaw 1989).
Eigen::RowVectorXd polar_row(const BSplineBasis& basis, int first, double a, double b, int ends) {
  const int n = basis.degree;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Identity(n + 1, n + 1);
  for (int r = 1; r <= n; ++r) {
    const double x = r <= ends ? b : a;
    for (int i = 0; i + r <= n; ++i) {
      const double lower = basis.knots[index(first + i + r - 1)], upper = basis.knots[index(first + i + n)];
      rows.row(i) = ((upper - x) * rows.row(i) + (x - lower) * rows.row(i + 1)) / (upper - lower);
    }
  }
  return rows.row(0);
}

}  // namespace

std::string reason_ill_formed(const BSplineBasis& basis) {
  const int n = basis.degree, m = basis.size();
  const std::vector<double>& knots = basis.knots;
  if (n < 1 || n > most_degree) return fmt::format("the degree is {}, it must be 1 to {}", n, most_degree);
  if (m <= n) return fmt::format("{} knots are too few, degree {} needs at least {}", knots.size(), n, 2 * n);
  const auto outside = [](double t) { return !(t >= 0.0 && t <= 1.0); };
  if (const auto bad = std::ranges::find_if(knots, outside); bad != knots.end())
    return fmt::format("knot {} is {}, knots lie in [0, 1]", bad - knots.begin() + 1, *bad);
  if (const auto bad = std::ranges::is_sorted_until(knots); bad != knots.end())
    return fmt::format("knot {} is smaller than the one before it", bad - knots.begin() + 1);
  for (int i = 0; i < n; ++i)
    if (knots[index(i)] != 0.0 || knots[knots.size() - 1 - index(i)] != 1.0)
      return fmt::format("the first and the last {} knots must be 0 and 1", n);
  for (int i = 0; i + n < static_cast<int>(knots.size()); ++i)
    if (knots[index(i)] == knots[index(i + n)]) return fmt::format("knot {} is repeated more than {} times", i + 1, n);
  return "";
}

BSplineBasis uniform_basis(int degree, int size) {
  BSplineBasis basis{degree, std::vector<double>(index(size + degree - 1), 0.0)};
  const int spans = size - degree;
  for (int i = 1; i <= spans; ++i) basis.knots[index(degree - 1 + i)] = static_cast<double>(i) / spans;
  std::fill(basis.knots.end() - degree, basis.knots.end(), 1.0);
  return basis;
}

std::vector<double> greville_abscissae(const BSplineBasis& basis) {
  std::vector<double> at;
  for (auto from = basis.knots.begin(); from + basis.degree <= basis.knots.end(); ++from)
    at.push_back(std::accumulate(from, from + basis.degree, 0.0) / basis.degree);
  return at;
}

std::vector<double> basis_integrals(const BSplineBasis& basis) {
  std::vector<double> integrals;
  const int last = static_cast<int>(basis.knots.size()) - 1;
  for (int i = 0; i < basis.size(); ++i) {
    const double from = basis.knots[index(std::max(i - 1, 0))];
    const double to = basis.knots[index(std::min(i + basis.degree, last))];
    integrals.push_back((to - from) / (basis.degree + 1));
  }
  return integrals;
}

std::vector<KnotSpan> spans_of(const BSplineBasis& basis) {
  std::vector<KnotSpan> spans;
  const int n = basis.degree;
  for (int j = n - 1; j + 1 < basis.size(); ++j) {
    const double from = basis.knots[index(j)], to = basis.knots[index(j + 1)];
    if (!(from < to)) continue;
    KnotSpan span{from, to, j + 1 - n, Eigen::MatrixXd(n + 1, n + 1)};
    for (int ends = 0; ends <= n; ++ends) span.to_bernstein.row(ends) = polar_row(basis, span.first, from, to, ends);
    spans.push_back(std::move(span));
  }
  return spans;
}

}  // namespace kappabench
