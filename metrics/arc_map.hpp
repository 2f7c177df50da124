#pragma once

#include <vector>

#include "metrics/panel_rule.hpp"
#include "schemes/curve/curve.hpp"

namespace kappabench {

/// A place on a curve.
struct CurvePlace {
  int segment;
  double t;
};

/// Arc length along a curve, both ways.
///
/// Method: the speed of every segment is replaced once by polynomials of degree 14 on panels, which start as its steady
/// stretches and are bisected until the length of each is known to 1e-13 of the segment's length (or to the rounding
/// noise of its coordinates). After that nothing is integrated again.
class ArcMap {
 public:
  explicit ArcMap(const Curve& curve);

  [[nodiscard]] double length() const { return starts_.back(); }
  [[nodiscard]] double segment_length(int segment) const;
  /// Is the length known to 1e-10, or to the rounding noise of the coordinates if that is more? Not so on segments that
  /// are not smooth, or not finite: what is measured along them is then NaN.
  [[nodiscard]] bool accurate() const { return accurate_; }
  /// Arc length from the start of the curve, 0 to length().
  [[nodiscard]] double position(const CurvePlace& place) const;
  /// The place at arc length s, taken modulo the length on a closed curve, clamped on an open one.
  [[nodiscard]] CurvePlace place(double s) const;

 private:
  struct Panel {
    double t0;
    double t1;
    double start;             ///< arc length from the start of the segment
    PanelRule::Values speed;  ///< Legendre coefficients, times half the width of the panel
    double length;
  };
  struct Aim {
    double error;         ///< of a panel
    double noise = 0.0;   ///< of the whole segment, summed over its panels
    double missed = 0.0;  ///< likewise the estimated error
  };
  void append_segment(const Segment& segment);
  void append_panels(const Segment& segment, double t0, double t1, int depth, Aim& aim);
  [[nodiscard]] const Panel* panels_of(std::size_t segment) const { return panels_.data() + first_[segment]; }

  bool closed_;
  bool accurate_ = true;
  std::vector<Panel> panels_;
  std::vector<std::size_t> first_;  ///< panel of each segment; one more at the end
  std::vector<double> starts_;      ///< arc length at the start of each segment; one more at the end
};

}  // namespace kappabench
