#include "metrics/monotone_intervals.hpp"

#include "metrics/curvature_profile.hpp"
#include "metrics/node_pieces.hpp"
#include "metrics/statistics.hpp"

namespace kappabench {
namespace {

constexpr double prominent = 0.01;  // of the curve's curvature range

std::vector<double> per_segment(const Curve& curve, const CurvatureProfile& profile, double prominence) {
  std::vector<double> intervals;
  for (int i = 0; i < curve.size(); ++i) {
    const auto turns = turning_points(profile.of_segment(i), profile.unit, prominence);
    intervals.push_back(1.0 + static_cast<double>(turns.size()));
  }
  return intervals;
}

std::vector<double> per_centred_piece(const Curve& curve, const CurvatureProfile& profile, double prominence) {
  const ArcMap arcs(curve);
  std::vector<double> intervals;
  for (const CentredPiece& piece : centred_pieces(curve, arcs)) {
    const auto turns = turning_points(profile_within(curve, profile, piece.parts), profile.unit, prominence);
    intervals.push_back(1.0 + static_cast<double>(turns.size()));
  }
  return intervals;
}

double fraction_of_at_most_two(const std::vector<double>& intervals) {
  double few = 0.0;
  for (const double n : intervals) few += n <= 2.0 ? 1.0 : 0.0;
  return intervals.empty() ? undefined : few / static_cast<double>(intervals.size());
}

}  // namespace

Metric monotone_intervals_metric() {
  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const CurvatureProfile profile = curvature_profile(curve, rounding_of(fit.input));
    const double visible = prominent * profile.range;
    const auto segments = per_segment(curve, profile, 0.0), visible_segments = per_segment(curve, profile, visible);
    const auto pieces = per_centred_piece(curve, profile, 0.0);
    const auto visible_pieces = per_centred_piece(curve, profile, visible);
    const auto extrema = [&](double prominence) {
      return static_cast<double>(turning_points(profile, curve.closed(), prominence).size());
    };
    const Method counted = method_of(profile.certification);
    const Method cut = Method::sampled;  // pieces end at arc-length midpoints, which are quadrature
    return std::vector<Measurement>{
        column::intervals_per_segment_mean(mean(segments), counted),
        column::intervals_per_segment_max(largest(segments), counted),
        column::segments_with_at_most_two_intervals(fraction_of_at_most_two(segments), counted),
        column::intervals_per_centred_piece_mean(mean(pieces), cut),
        column::intervals_per_centred_piece_max(largest(pieces), cut),
        column::centred_pieces_with_at_most_two_intervals(fraction_of_at_most_two(pieces), cut),
        column::curvature_extrema(extrema(0.0), counted),
        column::prominent_intervals_per_segment_mean(mean(visible_segments), counted),
        column::prominent_intervals_per_segment_max(largest(visible_segments), counted),
        column::prominent_intervals_per_centred_piece_mean(mean(visible_pieces), cut),
        column::prominent_intervals_per_centred_piece_max(largest(visible_pieces), cut),
        column::prominent_extrema(extrema(visible), counted)};
  };
  return {.id = "monotone_intervals",
          .title = "Intervals of monotone curvature",
          .version = 4,
          .columns = {column::intervals_per_segment_mean, column::intervals_per_segment_max,
                      column::segments_with_at_most_two_intervals, column::intervals_per_centred_piece_mean,
                      column::intervals_per_centred_piece_max, column::centred_pieces_with_at_most_two_intervals,
                      column::curvature_extrema, column::prominent_intervals_per_segment_mean,
                      column::prominent_intervals_per_segment_max, column::prominent_intervals_per_centred_piece_mean,
                      column::prominent_intervals_per_centred_piece_max, column::prominent_extrema},
          .measure = measure};
}

}  // namespace kappabench
