#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

namespace column {
inline const Column deviation_similarity{"deviation_similarity", "1",
                                         "points scaled by 3.7, turned by 0.7 rad and shifted: largest deviation over "
                                         "the mean chord; infinite if it cannot be fitted"};
inline const Column deviation_mirror{
    "deviation_mirror", "1", "points mirrored: largest deviation over the mean chord; infinite if it cannot be fitted"};
inline const Column deviation_reversal{
    "deviation_reversal", "1",
    "points in reverse order: largest deviation over the mean chord; infinite if it cannot be fitted"};
inline const Column deviation_cyclic_shift{"deviation_cyclic_shift", "1",
                                           "closed curves: another first point: largest deviation over the mean chord; "
                                           "infinite if it cannot be fitted; NaN on open curves"};
inline const Column deviation_extensionality_mean{"deviation_extensionality_mean", "1",
                                                  "a point of the curve added to the input: largest deviation over the "
                                                  "mean chord; infinite if it cannot be fitted; NaN without spans"};
inline const Column deviation_extensionality_max{"deviation_extensionality_max", "1",
                                                 "a point of the curve added to the input: largest deviation over the "
                                                 "mean chord; infinite if it cannot be fitted; NaN without spans"};
inline const Column sensitivity{"sensitivity", "1",
                                "all points moved by 1e-9 mean chord: largest deviation over displacement"};
[[nodiscard]] Column roundness(int corners);
}  // namespace column

/// Is the curve the same when the points are moved, turned, mirrored, listed the other way round, or joined by one that
/// is on the curve already? And how far does it jump for a change in the ninth digit?
[[nodiscard]] Metric invariance_metric();

/// Distance of the scheme's curve through the corners of a regular polygon from the circle through them. It does not
/// depend on the input.
[[nodiscard]] Metric roundness_metric();

}  // namespace kappabench
