#pragma once

#include "schemes/pkappa/segment_energy.hpp"
#include "schemes/pkappa/step.hpp"

namespace kappabench::pkappa {

/// P_i(t_i) = p_i to first order; the chain satisfies it, so the right-hand side is zero.
template <Continuity K>
void add_constraint(const JointChain& chain, std::size_t i, QuadraticModel<K>& model);

/// Half the gradient of a segment's energy by its control points and t.
template <Continuity K>
using SegmentGradient = Eigen::Matrix<double, SegmentNormal<Layout<K>::degree>::size, 1>;

/// Second derivatives of the control points by the joints' numbers, pulled by the energy and the multiplier, and of the
/// interpolated point by t.
template <Continuity K>
void add_curvature(const JointChain& chain, std::size_t i, const SegmentGradient<K>& gradient, const Vec2& multiplier,
                   QuadraticModel<K>& model);

}  // namespace kappabench::pkappa
