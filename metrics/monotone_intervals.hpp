#pragma once

#include "metrics/metric.hpp"

namespace kappabench {

namespace column {
inline const Column intervals_per_segment_mean{"intervals_per_segment_mean", "1",
                                               "monotone-curvature intervals of a segment, mean"};
inline const Column intervals_per_segment_max{"intervals_per_segment_max", "1",
                                              "monotone-curvature intervals of a segment, largest"};
inline const Column segments_with_at_most_two_intervals{"segments_with_at_most_two_intervals", "1",
                                                        "fraction of the segments"};
inline const Column intervals_per_centred_piece_mean{
    "intervals_per_centred_piece_mean", "1",
    "monotone-curvature intervals, mean, midpoint to midpoint around a node; NaN without interior nodes"};
inline const Column intervals_per_centred_piece_max{
    "intervals_per_centred_piece_max", "1",
    "monotone-curvature intervals, largest, midpoint to midpoint around a node; NaN without interior nodes"};
inline const Column centred_pieces_with_at_most_two_intervals{
    "centred_pieces_with_at_most_two_intervals", "1",
    "fraction of the pieces, midpoint to midpoint around a node; NaN without interior nodes"};
inline const Column curvature_extrema{"curvature_extrema", "1",
                                      "local extrema of curvature over the whole curve, joints included"};
/// Reversals under 1 % of the curve's curvature range ignored.
inline const Column prominent_intervals_per_segment_mean{
    "prominent_intervals_per_segment_mean", "1", "as above, reversals under 1 % of the curvature range ignored"};
inline const Column prominent_intervals_per_segment_max{"prominent_intervals_per_segment_max", "1",
                                                        "as above, reversals under 1 % of the curvature range ignored"};
inline const Column prominent_intervals_per_centred_piece_mean{"prominent_intervals_per_centred_piece_mean", "1",
                                                               "as above, reversals under 1 % of the range ignored"};
inline const Column prominent_intervals_per_centred_piece_max{"prominent_intervals_per_centred_piece_max", "1",
                                                              "as above, reversals under 1 % of the range ignored"};
inline const Column prominent_extrema{"prominent_extrema", "1",
                                      "local extrema of curvature, reversals under 1 % of the curvature range ignored"};
}  // namespace column

/// Into how many stretches of monotone curvature the curve falls: per segment, per piece around a node, and the
/// number of curvature extrema of the whole curve. Exact for segments whose d kappa / dt can be isolated, but for
/// pieces around a node: their ends are arc-length midpoints, by quadrature.
[[nodiscard]] Metric monotone_intervals_metric();

}  // namespace kappabench
