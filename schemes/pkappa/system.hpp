#pragma once

#include "schemes/pkappa/segment_energy.hpp"
#include "schemes/pkappa/step.hpp"

namespace kappabench::pkappa {

/// The weighted energy of a chain (Wang 2024, Eq. (6), each segment in its own unit), to second order in its unknowns,
/// subject to interpolation. Holds its workspace between calls.
template <Continuity K>
class ChainSystem {
 public:
  static constexpr int block = Layout<K>::block;
  using Vector = typename QuadraticModel<K>::Vector;
  using Step = typename QuadraticModel<K>::Step;

  ChainSystem(const QuadratureRule& rule, const Weights& weights) : energy_(rule), weights_(weights) {}

  /// Sum of the weighted energies; infinite if one is.
  [[nodiscard]] double value(const JointChain& chain);

  /// Energy, gradient and second derivatives of the Lagrangian at `chain`, which `step` then uses. `last` is the step
  /// that led here, for its multipliers; empty at the start, where they count as zero.
  double linearise(const JointChain& chain, const Step& last);

  void set_exact(bool exact) { exact_ = exact; }

  /// The step that minimises the quadratic model damped by `damping` times the mean diagonal of each kind of unknown,
  /// with t kept in its box. False if the system is singular.
  [[nodiscard]] bool step(const JointChain& chain, double damping, Step& out) {
    return boxed_.find(model_, chain, damping, out);
  }

  /// By how much the undamped model falls along a step of `step` with that damping.
  [[nodiscard]] double predicted_decrease(const Step& step, double damping) const;
  /// The part of it that belongs to one block.
  [[nodiscard]] double predicted_decrease(const Step& step, double damping, std::size_t block_row) const;

  /// Half the gradient of the energy, and the entry of half its second derivatives, bordered by the constraints', for
  /// two unknowns of the same or neighbouring blocks (else 0). Of an open chain.
  [[nodiscard]] const Step& gradient() const { return model_.gradient; }
  [[nodiscard]] double entry(std::size_t block_row, int row, std::size_t block_column, int column) const;

 private:
  void add_segment(const JointChain& chain, std::size_t i);
  void scale_damping(const JointChain& chain);

  SegmentEnergy<Layout<K>::degree> energy_;
  Weights weights_;
  SegmentNormal<Layout<K>::degree> normal_;
  QuadraticModel<K> model_;
  BoxedStep<K> boxed_;
  bool exact_ = false;
};

}  // namespace kappabench::pkappa
