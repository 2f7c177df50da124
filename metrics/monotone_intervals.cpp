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
  const std::string around = "midpoint to midpoint around a node; NaN without interior nodes";
  const std::vector<Column> columns{
      {"intervals_per_segment_mean", "1", "monotone-curvature intervals of a segment, mean"},
      {"intervals_per_segment_max", "1", "monotone-curvature intervals of a segment, largest"},
      {"segments_with_at_most_two_intervals", "1", "fraction of the segments"},
      {"intervals_per_centred_piece_mean", "1", "monotone-curvature intervals, mean, " + around},
      {"intervals_per_centred_piece_max", "1", "monotone-curvature intervals, largest, " + around},
      {"centred_pieces_with_at_most_two_intervals", "1", "fraction of the pieces, " + around},
      {"curvature_extrema", "1", "local extrema of curvature over the whole curve, joints included"},
      {"prominent_intervals_per_segment_mean", "1", "as above, reversals under 1 % of the curvature range ignored"},
      {"prominent_intervals_per_segment_max", "1", "as above, reversals under 1 % of the curvature range ignored"},
      {"prominent_intervals_per_centred_piece_mean", "1", "as above, reversals under 1 % of the range ignored"},
      {"prominent_intervals_per_centred_piece_max", "1", "as above, reversals under 1 % of the range ignored"},
      {"prominent_extrema", "1", "local extrema of curvature, reversals under 1 % of the curvature range ignored"}};

  const auto measure = [](const Scheme&, const Fit& fit) {
    const Curve& curve = *fit.curve;
    const CurvatureProfile profile = curvature_profile(curve);
    const Method method = profile.certified ? Method::exact : Method::sampled;
    std::vector<Measurement> row;
    const auto add = [&](const std::string& column, double value) { row.push_back({column, value, method}); };
    for (const bool filtered : {false, true}) {
      const double prominence = filtered ? prominent * profile.range : 0.0;
      const std::string stem = filtered ? "prominent_" : "";
      const auto segments = per_segment(curve, profile, prominence);
      const auto pieces = per_centred_piece(curve, profile, prominence);
      const auto extrema = static_cast<double>(turning_points(profile, curve.closed(), prominence).size());
      add(stem + "intervals_per_segment_mean", mean(segments));
      add(stem + "intervals_per_segment_max", largest(segments));
      if (!filtered) add("segments_with_at_most_two_intervals", fraction_of_at_most_two(segments));
      add(stem + "intervals_per_centred_piece_mean", mean(pieces));
      add(stem + "intervals_per_centred_piece_max", largest(pieces));
      if (!filtered) add("centred_pieces_with_at_most_two_intervals", fraction_of_at_most_two(pieces));
      add(filtered ? "prominent_extrema" : "curvature_extrema", extrema);
    }
    return row;
  };
  return {"monotone_intervals", "Intervals of monotone curvature", 1, columns, measure};
}

}  // namespace kappabench
