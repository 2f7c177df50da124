#include "schemes/segments/joint_claim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kappabench {
namespace {

/// What solvers are held to, relative: 4096 roundings.
constexpr double solved = 0x1p-40;

/// One end of a segment, and how far rounding of the coordinates moves a control point that was solved for and stored:
/// twice one unit in the last place. c' and c'' at an end are degree times a difference of two and degree (degree - 1)
/// times one of three control points, which counts as four.
struct End {
  Jet jet;
  double error;

  End(const Segment& segment, double t) : jet(segment.jet(t, 2)) {
    // Near the origin the other control points round by more than this one; c'' has their size where c' has not.
    const double largest = std::max(jet.position().cwiseAbs().maxCoeff(), jet.d[2].cwiseAbs().maxCoeff());
    error = 2.0 * std::numeric_limits<double>::epsilon() * largest;
  }

  /// The direction is not known to a tenth of a radian, for degree 5, the highest. True for what is not a number, too.
  [[nodiscard]] bool rests() const { return !(speed(jet) > 10.0 * (2.0 * 5.0 * error)); }
  /// Explained for degree 2, the lowest that bends.
  [[nodiscard]] double direction_error() const { return 2.0 * 2.0 * error / speed(jet); }
  [[nodiscard]] double curvature_error() const {  // of c' x c'' / |c'|^3
    const double v = speed(jet);
    return (4.0 * 2.0 * error + 4.0 * 2.0 * 2.0 * error * jet.d[2].norm() / v) / (v * v);
  }
};

bool have_one_direction(const End& before, const End& after) {
  return !before.rests() && !after.rests() && before.jet.d[1].dot(after.jet.d[1]) > 0.0;
}

}  // namespace

Continuity claim_at(const Segment& before, const Segment& after, Continuity smooth) {
  return have_one_direction(End(before, 1.0), End(after, 0.0)) ? smooth : Continuity::g0;
}

Continuity claim_across_point(const Segment& before, const Segment& after, Continuity smooth) {
  const End end(before, 1.0), start(after, 0.0);
  if (!have_one_direction(end, start)) return Continuity::g0;
  const double sine = std::abs(cross(end.jet.d[1], start.jet.d[1])) / (speed(end.jet) * speed(start.jet));
  if (sine > solved + end.direction_error() + start.direction_error()) return Continuity::g0;
  const double k0 = std::abs(curvature(end.jet)), k1 = std::abs(curvature(start.jet));
  const double explained = solved * std::max(k0, k1) + end.curvature_error() + start.curvature_error();
  return std::abs(k0 - k1) <= explained ? smooth : Continuity::g1;
}

}  // namespace kappabench
