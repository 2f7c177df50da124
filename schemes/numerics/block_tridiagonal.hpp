#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace kappabench {

/// A block tridiagonal matrix with dense square blocks of size `Block`: row k reads
/// lower[k] x[k-1] + diagonal[k] x[k] + upper[k] x[k+1]. In a cyclic one, `lower.front()` stands in the top
/// right corner and `upper.back()` in the bottom left one; else both are ignored.
template <int Block>
struct BlockTridiagonal {
  using Entry = Eigen::Matrix<double, Block, Block, Eigen::RowMajor>;

  std::vector<Entry> lower, diagonal, upper;
  bool cyclic = false;

  /// `n` block rows; the blocks keep whatever they held.
  void resize(std::size_t n) {
    lower.resize(n);
    diagonal.resize(n);
    upper.resize(n);
  }
  [[nodiscard]] std::size_t size() const { return diagonal.size(); }
};

/// `Columns` right-hand sides or solutions, one such matrix for each block row.
template <int Block, int Columns>
using BlockRight = Eigen::Matrix<double, Block, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

/// Gaussian elimination in a window that slides down the matrix. Its columns are the blocks k, k+1, k+2, if
/// cyclic also the last two blocks of all, and the right-hand sides; its rows are the block rows k, k+1 and, if
/// cyclic, the last one, which waits at the bottom and takes part in the pivoting. Part of BlockTridiagonalSolver.
template <int Block, int Columns, bool Cyclic>
class BlockElimination {
 public:
  using Matrix = BlockTridiagonal<Block>;
  using Right = BlockRight<Block, Columns>;

  [[nodiscard]] bool solve(const Matrix& matrix, std::span<Right> x) {
    const std::size_t n = matrix.size(), rows = Cyclic ? n - 1 : n;
    sliding_ = Cyclic ? n - 2 : n;
    eliminated_.resize(sliding_);
    window_.setZero();
    load(matrix, x, 0, 0);
    if constexpr (Cyclic) {
      put(bottom, 0, 0, matrix.upper[n - 1]);
      put(bottom, n - 2, 0, matrix.lower[n - 1]);
      put(bottom, n - 1, 0, matrix.diagonal[n - 1]);
      window_.template block<Block, Columns>(bottom, right) = x[n - 1];
    }
    for (std::size_t k = 0; k < sliding_; ++k) {
      if (k + 1 < rows) load(matrix, x, k + 1, k);
      if (!eliminate()) return false;
      eliminated_[k] = window_.template topRows<Block>();
      slide();
    }
    return substitute(x);
  }

 private:
  static constexpr int tail = 3 * Block;  ///< column where the last two blocks stand
  static constexpr int right = (Cyclic ? 5 : 3) * Block;
  static constexpr int width = right + Columns;
  static constexpr int bottom = 2 * Block;  ///< row where the last block row waits
  static constexpr int height = (Cyclic ? 3 : 2) * Block;

  /// Block row `row` of the matrix into the window that begins at column block `first`.
  void load(const Matrix& matrix, std::span<Right> x, std::size_t row, std::size_t first) {
    const std::size_t n = matrix.size();
    const int at = row == first ? 0 : Block;
    if (row > 0 || Cyclic) put(at, row > 0 ? row - 1 : n - 1, first, matrix.lower[row]);
    put(at, row, first, matrix.diagonal[row]);
    if (row + 1 < n) put(at, row + 1, first, matrix.upper[row]);
    window_.template block<Block, Columns>(at, right) = x[row];
  }

  /// Adds a block that stands in column block `column` of the matrix.
  void put(int row, std::size_t column, std::size_t first, const typename Matrix::Entry& entry) {
    const int at = column < sliding_ ? static_cast<int>(column - first) * Block
                                     : tail + static_cast<int>(column - sliding_) * Block;
    window_.template block<Block, Block>(row, at) += entry;
  }

  /// Clears the first `Block` columns below the diagonal.
  [[nodiscard]] bool eliminate() {
    for (int c = 0; c < Block; ++c) {
      int pivot = c;
      for (int r = c + 1; r < height; ++r)
        if (std::abs(window_(r, c)) > std::abs(window_(pivot, c))) pivot = r;
      const double diagonal = window_(pivot, c);
      if (!(std::abs(diagonal) > 0.0) || !std::isfinite(diagonal)) return false;
      if (pivot != c) window_.row(pivot).swap(window_.row(c));
      for (int r = c + 1; r < height; ++r) {
        const double factor = window_(r, c) / diagonal;
        if (factor != 0.0) window_.row(r) -= factor * window_.row(c);
      }
    }
    return true;
  }

  /// Moves the window one block down and right: the eliminated rows leave at the top, an empty second block row
  /// and an empty third block column come in.
  void slide() {
    for (int r = Block; r < height; ++r) {
      const int to = r < bottom ? r - Block : r;
      for (int c = 0; c < 2 * Block; ++c) window_(to, c) = window_(r, c + Block);
      for (int c = 2 * Block; c < 3 * Block; ++c) window_(to, c) = 0.0;
      for (int c = 3 * Block; c < width; ++c) window_(to, c) = window_(r, c);
    }
    window_.template middleRows<Block>(Block).setZero();
  }

  /// What is left of a cyclic matrix is a dense system for the last two blocks: the same elimination again.
  [[nodiscard]] bool solve_tail(std::span<Right> x, BlockRight<2 * Block, Columns>& last) {
    BlockTridiagonal<2 * Block> rest;
    rest.resize(1);
    rest.diagonal[0].template topRows<Block>() = window_.template block<Block, 2 * Block>(0, tail);
    rest.diagonal[0].template bottomRows<Block>() = window_.template block<Block, 2 * Block>(bottom, tail);
    last.template topRows<Block>() = window_.template block<Block, Columns>(0, right);
    last.template bottomRows<Block>() = window_.template block<Block, Columns>(bottom, right);
    BlockElimination<2 * Block, Columns, false> dense;
    if (!dense.solve(rest, std::span(&last, 1))) return false;
    x[sliding_] = last.template topRows<Block>();
    x[sliding_ + 1] = last.template bottomRows<Block>();
    return true;
  }

  [[nodiscard]] bool substitute(std::span<Right> x) {
    [[maybe_unused]] BlockRight<2 * Block, Columns> last;
    if constexpr (Cyclic)
      if (!solve_tail(x, last)) return false;
    for (std::size_t k = sliding_; k-- > 0;) {
      const Rows& u = eliminated_[k];
      Right b = u.template block<Block, Columns>(0, right);
      if (k + 1 < sliding_) b -= u.template block<Block, Block>(0, Block) * x[k + 1];
      if (k + 2 < sliding_) b -= u.template block<Block, Block>(0, 2 * Block) * x[k + 2];
      if constexpr (Cyclic) b -= u.template block<Block, 2 * Block>(0, tail) * last;
      for (int r = Block - 1; r >= 0; --r) {
        for (int c = r + 1; c < Block; ++c) b.row(r) -= u(r, c) * b.row(c);
        b.row(r) /= u(r, r);
      }
      if (!b.allFinite()) return false;
      x[k] = b;
    }
    return true;
  }

  using Rows = Eigen::Matrix<double, Block, width, Eigen::RowMajor>;
  Eigen::Matrix<double, height, width, Eigen::RowMajor> window_;
  std::vector<Rows> eliminated_;
  std::size_t sliding_ = 0;  ///< column blocks that pass through the window
};

/// Solves block tridiagonal systems by LU with row pivoting across neighbouring blocks: as stable as a banded LU,
/// also where a diagonal block is singular. Time and memory are linear in the number of blocks. Keeps its
/// workspace between calls, so that an iteration allocates once.
template <int Block, int Columns = 1>
class BlockTridiagonalSolver {
 public:
  using Matrix = BlockTridiagonal<Block>;
  using Right = BlockRight<Block, Columns>;

  /// In place: `x` holds the right-hand side and becomes the solution. False if the matrix is singular to working
  /// precision or not finite; `x` is then unspecified. A cyclic matrix needs at least 3 block rows. Throws
  /// std::invalid_argument when sizes do not fit.
  [[nodiscard]] bool solve(const Matrix& matrix, std::span<Right> x) {
    if (x.size() != matrix.size() || x.empty() || (matrix.cyclic && matrix.size() < 3))
      throw std::invalid_argument("BlockTridiagonalSolver: sizes do not fit");
    return matrix.cyclic ? cyclic_.solve(matrix, x) : open_.solve(matrix, x);
  }

 private:
  BlockElimination<Block, Columns, false> open_;
  BlockElimination<Block, Columns, true> cyclic_;
};

}  // namespace kappabench
