#pragma once

#include <memory>
#include <vector>

#include "metrics/metric.hpp"
#include "schemes/segments/polynomial.hpp"
#include "schemes/segments/trigonometric.hpp"

namespace kappabench::test {

inline SegmentPtr bezier(const std::vector<Vec2>& points) { return std::make_shared<PolynomialSegment>(points); }

/// A circular arc of less than 180 degrees from c0 to c2 with the tangents meeting in c1 (legs of equal length).
/// Exactly circular for a right angle (Miura 2022, Eq. (17) with a = 1/2).
inline SegmentPtr quarter_arc(const Vec2& c0, const Vec2& c1, const Vec2& c2) {
  const Vec2 middle = 0.25 * (c0 + 2.0 * c1 + c2);
  return std::make_shared<TrigonometricSegment>(std::array<Vec2, 5>{c0, 0.5 * (c0 + c1), middle, 0.5 * (c1 + c2), c2});
}

/// The circle of radius r around `centre` from four arcs, with a node in the middle of each.
inline Curve circle(double r, const Vec2& centre = Vec2::Zero()) {
  std::vector<SegmentPtr> segments;
  std::vector<Joint> joints;
  std::vector<Node> nodes;
  const Vec2 corners[] = {{r, 0}, {r, r}, {0, r}, {-r, r}, {-r, 0}, {-r, -r}, {0, -r}, {r, -r}, {r, 0}};
  for (int i = 0; i < 4; ++i) {
    segments.push_back(quarter_arc(centre + corners[2 * i], centre + corners[2 * i + 1], centre + corners[2 * i + 2]));
    joints.push_back({i, Continuity::c2});
    nodes.push_back({i, i, 0.5});
  }
  return Curve(segments, joints, nodes, true);
}

/// An open curve of one segment, with nodes at 0, `t`, and 1.
inline Curve single(const SegmentPtr& segment, double t = 0.5) {
  return Curve({segment}, {}, {{0, 0, 0.0}, {1, 0, t}, {2, 0, 1.0}}, false);
}

/// A fit whose points are where the curve's nodes are.
inline Fit fit_of(const Curve& curve) {
  Fit fit;
  for (const Node& node : curve.nodes()) {
    fit.input.points.push_back(curve.segment(node.segment).jet(node.t, 0).position());
  }
  fit.input.closed = curve.closed();
  fit.curve = curve;
  fit.report.outcome = Outcome::converged;
  return fit;
}

/// A scheme that metrics which only read the curve may be given.
class NoScheme final : public Scheme {
 public:
  NoScheme() : Scheme(SchemeInfo{"none", "none", "none"}, Parameters({}, {})) {}

 private:
  [[nodiscard]] Fit solve(const Input&) const override { return {}; }
};

inline Measurement measured(const Fit& fit, std::string_view id, std::string_view column) {
  for (const Measurement& m : find_metric(id).measure(NoScheme(), fit)) {
    if (m.column == column) return m;
  }
  throw std::logic_error("no column " + std::string(column));
}

inline double value(const Fit& fit, std::string_view id, std::string_view column) {
  return measured(fit, id, column).value;
}

}  // namespace kappabench::test
