#pragma once

#include "experiments/experiment.hpp"

namespace kappabench {

/// Miura 2022, Appendix C and Fig. 14: which bases the method applies to. Also the statements on the trigonometric
/// basis, Eqs. (15) to (17), (29), (42) and (43).
[[nodiscard]] Experiment ekappa_applicability_experiment();

}  // namespace kappabench
