#pragma once

#include <span>

#include "schemes/intrinsic/solve.hpp"

namespace kappabench::intrinsic {

/// A control curvature (counted from 0) that the user has put somewhere, times the chord.
struct MovedControl {
  int control;
  double value;
};

/// What the inner controls that were not moved do.
enum class Others {
  kept,         ///< stay where they are
  interpolated  ///< follow Yoshida 2022, Eqs. (10), (11) again, with the p of the settings
};

/// The curve after some of its control curvatures were moved, through the same Hermite data (Yoshida 2022, Sect. 5.4,
/// Fig. 9): knots stay, the two unknown controls are solved for anew. Those are the first and the last control, or the
/// ones next to them where the data give the end's curvature; they cannot be moved themselves
/// (`unsupported_input`). A large move may leave no solution (`not_converged`) or make extrema (`verdict_of`).
[[nodiscard]] HermiteFit with_moved_controls(const StandardData& data, const StandardCurve& curve,
                                             std::span<const MovedControl> moved, Others others, double p = 0.0);

}  // namespace kappabench::intrinsic
