#pragma once

#include <vector>

#include "metrics/panel_rule.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// A place on a curve.
struct Place {
  int segment;
  double t;
};

/// Arc length along a curve, both ways.
///
/// Method: the speed of every segment is replaced once by polynomials of degree 14 on panels, bisected until the
/// length of a panel is known to 1e-13 of the segment's length (or to the rounding noise of its coordinates) or the
/// panel is 2^-40 of the segment, as happens at a cusp. After that nothing is integrated again.
class ArcMap {
 public:
  explicit ArcMap(const Curve& curve);

  [[nodiscard]] double length() const { return starts_.back(); }
  [[nodiscard]] double segment_length(int segment) const;
  /// Arc length from the start of the curve, 0 to length().
  [[nodiscard]] double position(const Place& place) const;
  /// The place at arc length s, taken modulo the length on a closed curve, clamped on an open one.
  [[nodiscard]] Place place(double s) const;

 private:
  struct Panel {
    double t0;
    double t1;
    double start;             ///< arc length from the start of the segment
    PanelRule::Values speed;  ///< Legendre coefficients, times half the width of the panel
    double length;
  };
  /// `allowed` is the error of a panel, at depth 0 relative to the length.
  void append_panels(const Segment& segment, double t0, double t1, double allowed, int depth);
  [[nodiscard]] const Panel* panels_of(std::size_t segment) const { return panels_.data() + first_[segment]; }

  bool closed_;
  std::vector<Panel> panels_;
  std::vector<std::size_t> first_;  ///< panel of each segment; one more at the end
  std::vector<double> starts_;      ///< arc length at the start of each segment; one more at the end
};

}  // namespace kappabench
