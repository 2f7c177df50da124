#pragma once

#include <span>
#include <vector>

#include "schemes/fpc/chain.hpp"
#include "schemes/numerics/block_tridiagonal.hpp"

namespace kappabench::fpc {

using Block3 = BlockTridiagonal<3>;
using Right3 = BlockRight<3, 1>;

/// What is known about one segment of a state, and how far its equations are from holding.
struct Values {
  struct Segment {
    Vec2 x, y;                          ///< joints minus the point
    Vec2 start_velocity, end_velocity;  ///< by t
    double area;                        ///< T = X x Y
    double bend;                        ///< 3 log weight - log |T|, with |T| softened
    double share, rest;                 ///< lambda / (1 + lambda) of the joint at the segment's end, 1 / (1 + lambda)
    double unit;                        ///< length in which steps of that joint are solved for
    Vec2 gap;                           ///< of Eq. (16) at that joint, as a displacement of it
  };
  std::vector<Segment> segment;
  double merit = 0.0;  ///< sum over the equations, squared: gaps over the sizes, bends
  double worst = 0.0;  ///< the largest of them
};

/// The equations of an FPC-curve in terms of a State, for a Chain that outlives this object:
///   at joint k   (1 - s) Q_k'(1) = s Q_{k+1}'(0), s = lambda / (1 + lambda)   (Chen 2019, Eq. (16))
///   of segment k 3 log weight = log |T|                                      (Eq. (17))
/// `softness` d replaces |T| by sqrt(T^2 + (d size^2)^2): for large d the weights are constants and the problem is
/// linear in the joints, and the sign of T can change on the way to d = 0.
class System {
 public:
  explicit System(const Chain& chain);

  [[nodiscard]] const Chain& chain() const { return *chain_; }

  void evaluate(const State& state, double softness, Values& values) const;

  /// Newton's step is the solution of matrix * step = right, block k = (joint k in units of its `unit`, log weight k).
  /// Rows and columns are scaled so that pivoting does not carry the rounding of long segments into short ones.
  void linearise(const Values& values, double softness, Block3& matrix, std::vector<Right3>& right) const;

  /// Derivative of the equations by log softness, negated: the right-hand side of the path's tangent.
  void by_softness(const Values& values, double softness, std::vector<Right3>& right) const;

  /// The joints that satisfy Eq. (16) for given log lambda at each joint (Eq. (19)): one linear system, which gives
  /// x and y of `state`. False if it is singular.
  [[nodiscard]] bool solve_joints(std::span<const double> log_ratio, State& state) const;

  /// The equations (17) solved for the weights: log |T| / 3.
  void solve_weights(State& state) const;

  /// log lambda at every joint (Eq. (16)): velocity before the joint over that behind it.
  [[nodiscard]] std::vector<double> log_ratios(const State& state) const;

 private:
  [[nodiscard]] double soft_square(std::size_t k, double softness) const;

  const Chain* chain_;
  std::vector<double> log_bends_;  ///< by joint: log |end_bend_k / start_bend_{k+1}| / 3
  std::vector<double> scale_;      ///< by joint: what turns Eq. (16) into a relative displacement
};

/// How far a state is from an FPC-curve, scale-free: the largest, over the joints, of the angle and relative length of
/// the gap in Eq. (16) and of the relative mismatch of |kappa|. Where a segment is so straight that its curvature is
/// mostly rounding, |T| < 1e-3 |X||Y|, the mismatch counts in proportion to that.
[[nodiscard]] double residual_of(const Chain& chain, const State& state, std::span<const double> log_ratio);

}  // namespace kappabench::fpc
