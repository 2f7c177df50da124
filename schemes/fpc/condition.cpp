#include "schemes/fpc/condition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "schemes/numerics/block_tridiagonal.hpp"

namespace kappabench::fpc {
namespace {

constexpr int most_rounds = 5;

using Matrix = BlockTridiagonal<1>;
using Column = std::vector<BlockRight<1, 1>>;

double entry(const Matrix::Entry& block) { return block(0, 0); }

Matrix joint_matrix(const Chain& chain, std::span<const double> log_ratio) {
  const std::size_t n = chain.joints();
  Matrix matrix;
  matrix.resize(n);
  matrix.cyclic = chain.closed;
  for (std::size_t k = 0; k < n; ++k) {
    const LocalCubic &before = chain.cubic[k], &behind = chain.cubic[chain.next(k)];
    const double ratio = std::exp(log_ratio[k]);
    double lower = before.end_x, upper = -ratio * behind.start_y;
    const double diagonal = before.end_y - ratio * behind.start_x;
    if (!chain.closed && k == 0) lower = 0.0;
    if (!chain.closed && k + 1 == n) upper = 0.0;
    const double norm = std::abs(lower) + std::abs(diagonal) + std::abs(upper);
    matrix.lower[k](0, 0) = lower / norm;
    matrix.diagonal[k](0, 0) = diagonal / norm;
    matrix.upper[k](0, 0) = upper / norm;
  }
  return matrix;
}

Matrix transposed(const Matrix& a) {
  const std::size_t n = a.size();
  Matrix t = a;
  for (std::size_t k = 0; k < n; ++k) {
    t.lower[k] = a.upper[k > 0 ? k - 1 : n - 1];
    t.upper[k] = a.lower[k + 1 < n ? k + 1 : 0];
  }
  return t;
}

double norm(const Column& v) {
  double sum = 0.0;
  for (const auto& x : v) sum += std::abs(x(0, 0));
  return sum;
}

/// Largest column sum.
double norm(const Matrix& a) {
  const Matrix t = transposed(a);
  double largest = 0.0;
  for (std::size_t k = 0; k < t.size(); ++k)
    largest =
        std::max(largest, std::abs(entry(t.lower[k])) + std::abs(entry(t.diagonal[k])) + std::abs(entry(t.upper[k])));
  return largest;
}

}  // namespace

double joint_condition(const Chain& chain, std::span<const double> log_ratio) {
  const std::size_t n = chain.joints();
  if (n == 0) return 1.0;
  const Matrix a = joint_matrix(chain, log_ratio), t = transposed(a);
  BlockTridiagonalSolver<1> solver;
  Column x(n);
  for (auto& v : x) v(0, 0) = 1.0 / static_cast<double>(n);
  double estimate = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    if (!solver.solve(a, x)) return std::numeric_limits<double>::infinity();
    const double reached = norm(x);
    if (reached <= estimate) break;
    estimate = reached;
    for (auto& v : x) v(0, 0) = v(0, 0) < 0.0 ? -1.0 : 1.0;
    if (!solver.solve(t, x)) return std::numeric_limits<double>::infinity();
    std::size_t steepest = 0;
    for (std::size_t k = 1; k < n; ++k)
      if (std::abs(x[k](0, 0)) > std::abs(x[steepest](0, 0))) steepest = k;
    for (auto& v : x) v(0, 0) = 0.0;
    x[steepest](0, 0) = 1.0;
  }
  return estimate * norm(a);
}

}  // namespace kappabench::fpc
