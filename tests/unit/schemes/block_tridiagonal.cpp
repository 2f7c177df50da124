#include "schemes/numerics/block_tridiagonal.hpp"

#include <Eigen/LU>
#include <limits>
#include <random>

#include "tests/catch.hpp"

using namespace kappabench;

namespace {

template <int Block, int Columns>
struct Example {
  BlockTridiagonal<Block> matrix;
  std::vector<BlockRight<Block, Columns>> right;
  Eigen::MatrixXd dense, dense_right;
};

/// Random blocks; every third diagonal block is zero, so that only pivoting across blocks can work.
template <int Block, int Columns>
Example<Block, Columns> random_example(std::size_t n, bool cyclic, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto draw = [&] { return uniform(generator); };
  Example<Block, Columns> x;
  const auto size = static_cast<Eigen::Index>(n) * Block;
  x.matrix.cyclic = cyclic;
  x.matrix.resize(n);
  x.right.resize(n);
  x.dense = Eigen::MatrixXd::Zero(size, size);
  x.dense_right.resize(size, Columns);
  const auto at = [&](std::size_t row, std::size_t column) {
    return x.dense.template block<Block, Block>(static_cast<Eigen::Index>(row) * Block,
                                                static_cast<Eigen::Index>(column) * Block);
  };
  for (std::size_t k = 0; k < n; ++k) {
    for (auto* entry : {&x.matrix.lower[k], &x.matrix.diagonal[k], &x.matrix.upper[k]})
      *entry = BlockTridiagonal<Block>::Entry::NullaryExpr(draw);
    if (k % 3 == 1) x.matrix.diagonal[k].setZero();
    at(k, k) += x.matrix.diagonal[k];
    if (k > 0 || cyclic) at(k, (k + n - 1) % n) += x.matrix.lower[k];
    if (k + 1 < n || cyclic) at(k, (k + 1) % n) += x.matrix.upper[k];
    x.right[k] = BlockRight<Block, Columns>::NullaryExpr(draw);
    x.dense_right.middleRows(static_cast<Eigen::Index>(k) * Block, Block) = x.right[k];
  }
  return x;
}

template <int Block, int Columns>
void check_against_dense(bool cyclic) {
  std::mt19937_64 generator(17);
  BlockTridiagonalSolver<Block, Columns> solver;
  for (std::size_t n = cyclic ? 3 : 1; n < 12; ++n) {
    Example<Block, Columns> x = random_example<Block, Columns>(n, cyclic, generator);
    if (Eigen::FullPivLU<Eigen::MatrixXd>(x.dense).rcond() < 1e-6) continue;
    REQUIRE(solver.solve(x.matrix, x.right));
    Eigen::MatrixXd solution(x.dense_right.rows(), Columns);
    for (std::size_t k = 0; k < n; ++k) solution.middleRows(static_cast<Eigen::Index>(k) * Block, Block) = x.right[k];
    INFO("block " << Block << ", n " << n << ", cyclic " << cyclic);
    CHECK((x.dense * solution - x.dense_right).norm() <= 1e-12 * (1.0 + solution.norm()));
  }
}

}  // namespace

TEST_CASE("block tridiagonal systems agree with a dense solution", "[block_tridiagonal]") {
  for (const bool cyclic : {false, true}) {
    check_against_dense<1, 2>(cyclic);
    check_against_dense<2, 3>(cyclic);
    check_against_dense<3, 1>(cyclic);
    check_against_dense<4, 1>(cyclic);
  }
}

TEST_CASE("singular and broken block tridiagonal systems are refused", "[block_tridiagonal]") {
  BlockTridiagonalSolver<2> solver;
  BlockTridiagonal<2> matrix;
  matrix.resize(3);
  for (auto* blocks : {&matrix.lower, &matrix.diagonal, &matrix.upper})
    for (auto& block : *blocks) block.setZero();
  std::vector<BlockRight<2, 1>> right(3, BlockRight<2, 1>::Ones());
  CHECK_FALSE(solver.solve(matrix, right));

  for (auto& block : matrix.diagonal) block.setIdentity();
  matrix.diagonal[1](0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(solver.solve(matrix, right));

  std::vector<BlockRight<2, 1>> short_right(2);
  CHECK_THROWS_AS(solver.solve(matrix, short_right), std::invalid_argument);
  matrix.cyclic = true;
  matrix.resize(2);
  CHECK_THROWS_AS(solver.solve(matrix, short_right), std::invalid_argument);
}
