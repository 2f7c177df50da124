#pragma once

#include <Eigen/Core>
#include <vector>

#include "schemes/intrinsic/hermite_data.hpp"
#include "schemes/numerics/sine_cosine.hpp"

namespace kappabench::intrinsic {

/// Many points of curves on the same knots, equally spaced in arc length, both ends included: what Yoshida 2022, Table
/// 1 times with 500 of them. Set up once for a basis.
///
/// One pass of the trapezium rule with its first correction between neighbouring points and knots: the curvature that
/// it needs is known, so one sine and cosine a point is all. With 500 points on a curve that turns by 3 rad the error
/// is about 1e-12 chords, and falls with the fourth power of the number; the segment's own jets are exact to rounding.
class Sampler {
 public:
  /// `count` >= 2 points.
  Sampler(const BSplineBasis& basis, int count);

  /// Of a curve in standard form on this basis, with its start at the origin and its chord along the x axis.
  [[nodiscard]] std::vector<Vec2> points(const StandardCurve& curve, double chord_angle, Sines sines) const;

 private:
  /// The nodes of a knot span are its ends and the samples between them.
  struct Span {
    int first_control;
    Eigen::MatrixXd to_powers;  ///< controls to the angle's rise over the length, in powers of x; that of 0 is 0
    Eigen::ArrayXd x;           ///< parameters of the nodes, less that of the span's start
    Eigen::ArrayXd half_step, correction;  ///< h / 2 and h^2 / 12 between neighbouring nodes
    int first_sample;
    int samples;
    int first_sampled_node;  ///< 0 if the span starts at a sample, else 1
  };

  int count_;
  std::vector<Span> spans_;
};

}  // namespace kappabench::intrinsic
