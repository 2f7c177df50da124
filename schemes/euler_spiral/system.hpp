#pragma once

#include <span>
#include <vector>

#include "schemes/euler_spiral/polygon.hpp"
#include "schemes/euler_spiral/span.hpp"
#include "schemes/numerics/block_tridiagonal.hpp"

namespace kappabench::euler_spiral {

/// The spline's equations, one a point, and the spans they are taken from (Bertolazzi and Frego 2018):
/// - at a point between two spans, the jump of curvature there times the shorter chord is 0;
/// - at an open end the heading is the given one, or else the span is a circular arc, whose headings against its chord
///   are opposite. Two points alone without given headings leave the arc open: it is straight.
/// A tridiagonal system, cyclic for a closed polygon. Keeps its workspace; the polygon must outlive it.
class System {
 public:
  explicit System(const Polygon& polygon);

  /// With all turns, and given headings, times `bend`. False if a span has no clothoid; what is kept is then
  /// unspecified.
  [[nodiscard]] bool evaluate(std::span<const double> headings, double bend);

  // Of the last evaluation:
  [[nodiscard]] double residual() const;  ///< the largest equation
  [[nodiscard]] double squares() const;   ///< the sum of their squares
  [[nodiscard]] const std::vector<Span>& spans() const { return spans_; }

  /// Newton's step, and the derivatives of the solution by `bend`. False if the Jacobian is singular.
  [[nodiscard]] bool solve(std::vector<double>& step, std::vector<double>& by_bend);

 private:
  /// An equation, and its derivatives by the headings of the point before, the point, the next one, and by `bend`.
  struct Row {
    double value, lower, diagonal, upper, by_bend;
  };
  [[nodiscard]] Row at_end(std::size_t k, std::span<const double> headings, double bend) const;
  [[nodiscard]] Row between_spans(std::size_t k) const;

  const Polygon& polygon_;
  std::vector<Span> spans_;
  std::vector<double> values_, by_bend_;  ///< the equations, and their derivatives by `bend`
  BlockTridiagonal<1> matrix_;
  BlockTridiagonalSolver<1, 2> solver_;
  std::vector<BlockRight<1, 2>> columns_;
};

}  // namespace kappabench::euler_spiral
