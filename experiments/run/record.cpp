#include "experiments/run/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "schemes/api/curve_json.hpp"
#include "schemes/curve/arc_length.hpp"

namespace kappabench {

namespace {

/// Enough samples for a smooth line and comb at print size, fewer for curves of thousands of segments.
int samples_per_segment(const Curve& curve) { return std::clamp(40000 / curve.size(), 5, 65); }

/// Arc length at the start of every segment, and the whole length last.
std::vector<double> segment_starts(const Curve& curve) {
  std::vector<double> starts{0.0};
  for (const SegmentPtr& segment : curve.segments())
    starts.push_back(starts.back() + arc_length(*segment, 0.0, 1.0, 1e-9));
  return starts;
}

void add_samples(store::CurveRecord& record, const Curve& curve, const std::vector<double>& starts) {
  const CurveSamples samples = sample(curve, samples_per_segment(curve), 2);
  record.samples_per_segment = static_cast<int>(samples.t.size());
  for (int k = 0; k < curve.size(); ++k) {
    double s = starts[static_cast<std::size_t>(k)];
    const auto jets = samples.of_segment(k);
    for (std::size_t j = 0; j < jets.size(); ++j) {
      // Within a segment the trapezoid of the speed is close enough to draw with; segments start exactly.
      if (j > 0) s += 0.5 * (speed(jets[j - 1]) + speed(jets[j])) * (samples.t[j] - samples.t[j - 1]);
      const Vec2 normal = left_normal(jets[j].d[1]).normalized();
      record.sample_x.push_back(jets[j].position().x());
      record.sample_y.push_back(jets[j].position().y());
      record.sample_kappa.push_back(curvature(jets[j]));
      record.sample_s.push_back(s);
      record.sample_normal_x.push_back(normal.x());
      record.sample_normal_y.push_back(normal.y());
    }
  }
}

void add_nodes(store::CurveRecord& record, const Curve& curve, const std::vector<double>& starts) {
  for (const Node& node : curve.nodes()) {
    const Segment& segment = curve.segment(node.segment);
    const Jet jet = segment.jet(node.t, 2);
    record.node_point.push_back(node.point);
    record.node_segment.push_back(node.segment);
    record.node_t.push_back(node.t);
    record.node_x.push_back(jet.position().x());
    record.node_y.push_back(jet.position().y());
    record.node_s.push_back(starts[static_cast<std::size_t>(node.segment)] + arc_length(segment, 0.0, node.t, 1e-9));
    record.node_kappa.push_back(curvature(jet));
    record.node_marks.push_back(fmt::format("{}", fmt::join(node.marks, " ")));
  }
}

void add_joints(store::CurveRecord& record, const Curve& curve, const std::vector<double>& starts) {
  for (const Joint& joint : curve.joints()) {
    const Vec2 position = curve.segment(joint.segment).jet(1.0, 0).position();
    record.joint_segment.push_back(joint.segment);
    record.joint_claimed.emplace_back(name(joint.claimed));
    record.joint_x.push_back(position.x());
    record.joint_y.push_back(position.y());
    record.joint_s.push_back(starts[static_cast<std::size_t>(joint.segment) + 1]);
  }
}

}  // namespace

store::CurveRecord record_of(const Scheme& scheme, const Fit& fit, std::span<const Metric* const> metrics) {
  store::CurveRecord record;
  record.closed = fit.input.closed;
  for (const Vec2& p : fit.input.points) {
    record.point_x.push_back(p.x());
    record.point_y.push_back(p.y());
  }
  record.outcome = name(fit.report.outcome);
  record.message = fit.report.message;
  record.iterations = fit.report.iterations;
  record.residual = fit.report.residual;
  record.seconds = fit.report.seconds;
  record.trace = fit.report.trace;
  record.counters = fit.report.counters;
  record.warnings = fit.report.warnings;
  if (!fit.curve) return record;

  record.exact_json = curve_json(scheme, fit);
  const std::vector<double> starts = segment_starts(*fit.curve);
  add_samples(record, *fit.curve, starts);
  add_nodes(record, *fit.curve, starts);
  add_joints(record, *fit.curve, starts);
  for (const Metric* metric : metrics)
    for (const Measurement& m : metric->measure(scheme, fit))
      record.measurements.push_back({m.column, m.value, std::string(name(m.method)), m.unit});
  return record;
}

}  // namespace kappabench
