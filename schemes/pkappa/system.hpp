#pragma once

#include <vector>

#include "schemes/numerics/block_tridiagonal.hpp"
#include "schemes/pkappa/chain.hpp"
#include "schemes/pkappa/segment_energy.hpp"

namespace kappabench::pkappa {

/// The weighted energy of a chain (Wang 2024, Eq. (6)), to second order in its unknowns, subject to interpolation.
/// Block i holds the unknowns of joint i and segment i (see Layout); the last block of an open chain has only a joint.
/// Holds its workspace between calls.
template <Continuity K>
class ChainSystem {
 public:
  static constexpr int block = Layout<K>::block;
  using Vector = Eigen::Matrix<double, block, 1>;
  using Step = std::vector<Vector>;

  ChainSystem(const QuadratureRule& rule, const Weights& weights) : energy_(rule), weights_(weights) {}

  /// Sum of the weighted energies; infinite if one is.
  [[nodiscard]] double value(const Chain& chain);

  /// Energy, gradient and second derivatives of the Lagrangian at `chain`, which `step` then uses. `last` is the step
  /// that led here, for its multipliers; empty at the start, where they count as zero.
  double linearise(const Chain& chain, const Step& last);

  void set_exact(bool exact) { exact_ = exact; }

  /// The step that minimises the quadratic model damped by `damping` times the mean diagonal of each kind of unknown,
  /// with t kept in its box. False if the system is singular.
  [[nodiscard]] bool step(const Chain& chain, double damping, Step& out);

  /// By how much the undamped model falls along a step of `step` with that damping.
  [[nodiscard]] double predicted_decrease(const Step& step, double damping) const;
  /// The part of it that belongs to one block.
  [[nodiscard]] double predicted_decrease(const Step& step, double damping, std::size_t block_row) const;

  /// Half the gradient of the energy, and the entry of half its second derivatives, bordered by the constraints', for
  /// two unknowns of the same or neighbouring blocks (else 0). Of an open chain.
  [[nodiscard]] const Step& gradient() const { return gradient_; }
  [[nodiscard]] double entry(std::size_t block_row, int row, std::size_t block_column, int column) const;

 private:
  void add_segment(const Chain& chain, std::size_t i);
  void add_constraint(const Chain& chain, std::size_t i);
  void add_curvature(const Chain& chain, std::size_t i, const Vec2& multiplier);
  void scale_damping();
  [[nodiscard]] bool solve(const Chain& chain, double damping, Step& out);
  [[nodiscard]] double slope_of_held(const Chain& chain, std::size_t i, double damping, const Step& step) const;

  SegmentEnergy<Layout<K>::degree> energy_;
  Weights weights_;
  SegmentNormal<Layout<K>::degree> normal_;
  BlockTridiagonal<block> matrix_, damped_;
  Step gradient_, scale_;
  std::vector<double> held_;  ///< the change of a t that is held at an edge of its box, else NaN
  bool exact_ = false;
  BlockTridiagonalSolver<block> solver_;
};

/// Whether number `v` of a block may change, with this freedom of its joint and, in the last block of an open chain,
/// without a segment.
template <Continuity K>
[[nodiscard]] constexpr bool is_free(int v, Freedom freedom, bool has_segment) {
  using L = Layout<K>;
  if (v >= L::joint) return has_segment;
  if (freedom == Freedom::none) return false;
  if (freedom == Freedom::end_point) return v >= 2 && v < 2 * L::vectors;
  return true;
}

/// The chain after a step, interpolation restored. False if it cannot be.
template <Continuity K>
[[nodiscard]] bool advance(const Chain& from, const typename ChainSystem<K>::Step& step, Chain& to);

}  // namespace kappabench::pkappa
