#pragma once

#include <vector>

#include "schemes/numerics/block_tridiagonal.hpp"
#include "schemes/pkappa/joint_chain.hpp"

namespace kappabench::pkappa {

/// The weighted energy of a chain to second order in its unknowns, subject to interpolation. Block i holds the unknowns
/// of joint i and segment i (see Layout); the last block of an open chain has only a joint.
template <Continuity K>
struct QuadraticModel {
  static constexpr int block = Layout<K>::block;
  using Vector = Eigen::Matrix<double, block, 1>;
  using Step = std::vector<Vector>;

  BlockTridiagonal<block> matrix;  ///< half the second derivatives, bordered by the constraints'
  Step gradient;                   ///< half of it
  Step scale;                      ///< what damping multiplies
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

/// Steps that minimise a damped model with every t in its box. Begins with those t on an edge that the step before held
/// there.
template <Continuity K>
class BoxedStep {
 public:
  using Step = typename QuadraticModel<K>::Step;

  /// False if the system is singular.
  [[nodiscard]] bool find(const QuadraticModel<K>& model, const JointChain& chain, double damping, Step& out);

 private:
  static constexpr int block = Layout<K>::block;

  [[nodiscard]] bool solve(const QuadraticModel<K>& model, const JointChain& chain, double damping, Step& out);

  BlockTridiagonal<block> damped_;
  std::vector<double> held_;  ///< the change of a t that is held at an edge of its box, else NaN
  BlockTridiagonalSolver<block> solver_;
};

/// The chain after a step, interpolation restored. False if it cannot be.
template <Continuity K>
[[nodiscard]] bool advance(const JointChain& from, const typename QuadraticModel<K>::Step& step, JointChain& to);

}  // namespace kappabench::pkappa
