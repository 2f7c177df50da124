#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <vector>

#include "schemes/api/scheme.hpp"
#include "schemes/segments/polynomial.hpp"

namespace kappabench::test {

/// The polygon of the points: the most local scheme there is. `bias` spoils its invariance: it bends every edge by that
/// much in the y direction.
class PolygonScheme final : public Scheme {
 public:
  explicit PolygonScheme(double bias = 0.0)
      : Scheme(SchemeInfo{"polygon", "polygon", "none"}, Parameters({}, {})), bias_(bias) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override {
    const int n = input.size();
    const int edges = input.closed ? n : n - 1;
    std::vector<SegmentPtr> segments;
    std::vector<Joint> joints;
    std::vector<Node> nodes;
    for (int i = 0; i < edges; ++i) {
      const Vec2& a = input.points[static_cast<std::size_t>(i)];
      const Vec2& b = input.points[static_cast<std::size_t>((i + 1) % n)];
      const Vec2 middle = 0.5 * (a + b) + Vec2(0.0, bias_);
      segments.push_back(std::make_shared<PolynomialSegment>(std::vector<Vec2>{a, middle, b}));
      if (input.closed || i + 1 < edges) joints.push_back({i, Continuity::g0});
      nodes.push_back({i, i, 0.0});
    }
    if (!input.closed) nodes.push_back({n - 1, edges - 1, 1.0});
    Fit fit;
    fit.input = input;
    fit.curve = Curve(segments, joints, nodes, input.closed);
    fit.report.outcome = Outcome::converged;
    return fit;
  }

  double bias_;
};

/// The closed C2 cubic spline with uniform knots: moving a point is felt everywhere, and the tangents
/// answer with the factor 2 - sqrt(3) from one span to the next.
class UniformSpline final : public Scheme {
 public:
  UniformSpline() : Scheme(SchemeInfo{"uniform", "uniform C2 spline", "none"}, Parameters({}, {})) {}

 private:
  [[nodiscard]] Fit solve(const Input& input) const override {
    const int n = input.size();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd b(n, 2);
    const auto point = [&](int i) { return input.points[static_cast<std::size_t>((i + n) % n)]; };
    for (int i = 0; i < n; ++i) {
      a(i, (i + n - 1) % n) += 1.0;
      a(i, i) += 4.0;
      a(i, (i + 1) % n) += 1.0;
      b.row(i) = 3.0 * (point(i + 1) - point(i - 1)).transpose();
    }
    const Eigen::MatrixXd m = a.partialPivLu().solve(b);
    std::vector<SegmentPtr> segments;
    std::vector<Joint> joints;
    std::vector<Node> nodes;
    for (int i = 0; i < n; ++i) {
      const Vec2 p = point(i);
      const Vec2 q = point(i + 1);
      const Vec2 from = m.row(i).transpose();
      const Vec2 to = m.row((i + 1) % n).transpose();
      segments.push_back(std::make_shared<PolynomialSegment>(std::vector<Vec2>{p, p + from / 3.0, q - to / 3.0, q}));
      joints.push_back({i, Continuity::c2});
      nodes.push_back({i, i, 0.0});
    }
    Fit fit;
    fit.input = input;
    fit.curve = Curve(segments, joints, nodes, true);
    fit.report.outcome = Outcome::converged;
    return fit;
  }
};

inline Input ring(int n, bool closed = true) {
  Input input;
  input.closed = closed;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    const double r = 1.0 + 0.2 * std::sin(5.0 * i) + 0.1 * std::cos(2.3 * i);
    input.points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return input;
}

}  // namespace kappabench::test
