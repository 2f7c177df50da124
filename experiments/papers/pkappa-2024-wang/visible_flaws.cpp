#include "experiments/papers/pkappa-2024-wang/visible_flaws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/continuity.hpp"
#include "metrics/curvature_profile.hpp"
#include "metrics/node_pieces.hpp"

namespace kappabench::wang {

namespace {

double curvature_at(const Curve& curve, const CurvePlace& place) {
  return curvature(curve.segment(place.segment).jet(place.t, 2));
}

Vec2 position_of(const Curve& curve, const Node& node) { return curve.segment(node.segment).jet(node.t, 0).position(); }

/// Everything the searches share.
struct Measured {
  const Curve& curve;
  CurvatureProfile profile;
  ArcMap arcs;
  std::vector<PlacedNode> nodes;

  [[nodiscard]] double prominence() const { return visible_reversal * profile.range; }
};

/// Number of turns of curvature inside a stretch.
std::size_t turns_inside(const Measured& m, const std::vector<Part>& parts) {
  return turning_points(profile_within(m.curve, m.profile, parts), m.profile.unit, m.prominence()).size();
}

void find_jumps(const Measured& m, const Input& input, VisibleFlaws& found) {
  for (const JointJump& jump : joint_jumps(m.curve, input)) {
    ++found.joints;
    if (!(jump.curvature > visible_jump + jump.curvature_uncertainty)) continue;
    const int segment = jump.joint.segment;
    found.jumps.push_back(m.curve.segment(segment).jet(1.0, 0).position());
    const double before = curvature_at(m.curve, {segment, 1.0}),
                 after = curvature_at(m.curve, {m.curve.next(segment), 0.0});
    if (before * after < 0.0) ++found.jumps_at_sign_changes;
  }
}

/// Mean of the chords to both neighbours.
double local_chord(const Input& input, int point) {
  const auto n = input.points.size(), i = static_cast<std::size_t>(point);
  const bool first = i == 0 && !input.closed, last = i + 1 == n && !input.closed;
  const Vec2& here = input.points[i];
  const double before = first ? 0.0 : (here - input.points[(i + n - 1) % n]).norm();
  const double after = last ? 0.0 : (input.points[(i + 1) % n] - here).norm();
  return first ? after : last ? before : 0.5 * (before + after);
}

/// Distance along the curve from s to the nearest of `places`; infinite if there is none.
double distance_to(const std::vector<double>& places, double s, const Measured& m) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double place : places) {
    const double direct = std::abs(s - place);
    nearest = std::min(nearest, m.curve.closed() ? std::min(direct, m.arcs.length() - direct) : direct);
  }
  return nearest;
}

void find_points_off(const Measured& m, const Input& input, VisibleFlaws& found) {
  std::vector<double> extrema, peaks;
  for (const TurningPoint& turn : turning_points(m.profile, m.curve.closed(), m.prominence())) {
    const ProfilePoint& point = m.profile.points[turn.index];
    extrema.push_back(m.arcs.position(point.place));
    if (turn.maximum == (point.curvature > 0.0)) peaks.push_back(extrema.back());
  }
  for (const PlacedNode& node : m.nodes) {
    if (at_end(node, m.curve, m.arcs)) continue;
    ++found.points;
    const double far = visible_offset * local_chord(input, node.node.point);
    if (distance_to(extrema, node.position, m) > far) found.off_extrema.push_back(position_of(m.curve, node.node));
    if (distance_to(peaks, node.position, m) > far) ++found.points_off_peaks;
  }
}

void find_many_intervals(const Measured& m, VisibleFlaws& found) {
  for (const CentredPiece& piece : centred_pieces(m.curve, m.arcs)) {
    ++found.pieces;
    if (turns_inside(m, piece.parts) > 1) found.many_intervals.emplace_back(piece.start, piece.end);
  }
}

void find_alternating(const Measured& m, VisibleFlaws& found) {
  const std::size_t n = m.nodes.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (i + 1 == n && !m.curve.closed()) continue;
    const PlacedNode &from = m.nodes[i], &to = m.nodes[(i + 1) % n];
    const double k0 = curvature_at(m.curve, {from.node.segment, from.node.t});
    const double k1 = curvature_at(m.curve, {to.node.segment, to.node.t});
    if (!(k0 * k1 < 0.0)) continue;
    ++found.alternating_spans;
    const double end = i + 1 == n ? to.position + m.arcs.length() : to.position;
    if (turns_inside(m, parts_between(m.curve, m.arcs, from.position, end)) > 0) ++found.alternating_not_monotone;
  }
}

}  // namespace

VisibleFlaws visible_flaws(const Fit& fit) {
  const Curve& curve = *fit.curve;
  const ArcMap arcs(curve);
  const Measured measured{curve, curvature_profile(curve, rounding_of(fit.input)), arcs, nodes_in_order(curve, arcs)};
  VisibleFlaws found;
  find_jumps(measured, fit.input, found);
  find_points_off(measured, fit.input, found);
  find_many_intervals(measured, found);
  find_alternating(measured, found);
  return found;
}

}  // namespace kappabench::wang
