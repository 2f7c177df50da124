#pragma once

#include <span>

#include "schemes/fpc/cubic_chain.hpp"

namespace kappabench::fpc {

/// Estimate, from below and usually within a factor of 3, of the condition number in the 1-norm of the linear system
/// for the joints (Chen 2019, Eq. (19)), its rows scaled to unit 1-norm; infinite if it is singular. Five to ten
/// solves of the system (Hager 1984, Higham 1988).
[[nodiscard]] double joint_condition(const CubicChain& chain, std::span<const double> log_ratio);

/// From here on the joints have no digits that mean anything.
inline constexpr double singular_condition = 1e12;

}  // namespace kappabench::fpc
