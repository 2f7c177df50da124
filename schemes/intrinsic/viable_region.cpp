#include "schemes/intrinsic/viable_region.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace kappabench::intrinsic {

namespace {

constexpr double angle_rounding = 1e-13;  ///< radians: what angles from coordinates are known to

}  // namespace

Viability viability(const StandardData& data) {
  const bool rising = data.turning > 2.0 * data.chord_angle;
  const double sign = rising ? 1.0 : -1.0;
  const double half = std::sin(0.5 * (data.turning - 2.0 * data.chord_angle));
  Viability v{.rising = rising,
              .start_slack = sign * (2.0 * std::sin(data.chord_angle) - data.start_curvature.value()),
              .end_slack = sign * (data.end_curvature.value() - 2.0 * std::sin(data.end_angle())),
              .least_product = 4.0 * half * half,
              .nesting = std::numeric_limits<double>::quiet_NaN()};
  // Angles that agree to rounding leave no room between the circles.
  if (std::abs(half) <= angle_rounding) v.least_product = 0.0;
  if (!v.only_circle()) v.nesting = v.start_slack * v.end_slack / v.least_product;
  return v;
}

std::string reason_not_viable(const Viability& v) {
  if (v.viable()) return "";
  const char* const way = v.rising ? "rising" : "falling";
  if (v.only_circle())
    return "the angles are those of a circular arc, so the curvature of both ends must be that of the arc";
  if (!(v.start_slack > 0.0))
    return fmt::format(
        "{} curvature starts {} the circle through both points, 2 sin(chord angle) / chord; it is off by {:.6g}", way,
        v.rising ? "below" : "above", -v.start_slack);
  if (!(v.end_slack > 0.0))
    return fmt::format(
        "{} curvature ends {} the circle through both points, 2 sin(end angle) / chord; it is off by {:.6g}", way,
        v.rising ? "above" : "below", -v.end_slack);
  return fmt::format("the osculating circles at the ends do not nest: xi = {:.6g}, {} curvature needs more than 1",
                     v.nesting, way);
}

double least_end_curvature(double chord_angle, double turning, double start_curvature) {
  const double room = 2.0 * std::sin(chord_angle) - start_curvature;
  if (!(room > 0.0)) return std::numeric_limits<double>::infinity();
  return (2.0 * (1.0 - std::cos(turning)) - 2.0 * start_curvature * std::sin(turning - chord_angle)) / room;
}

}  // namespace kappabench::intrinsic
