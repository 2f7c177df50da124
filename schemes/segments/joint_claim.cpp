#include "schemes/segments/joint_claim.hpp"

#include <algorithm>
#include <limits>

#include "schemes/curve/joint.hpp"

namespace kappabench {
namespace {

/// As far as the two segments show how coordinates round.
JointSides sides_between(const Segment& before, const Segment& after) {
  double largest = 0.0;
  for (const Vec2& p : {position_at(before, 0.0), position_at(after, 0.0), position_at(after, 1.0)})
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return sides_of(before, after, std::numeric_limits<double>::epsilon() * largest);
}

/// The direction is known to a tenth of a radian. False for what is not a number, too.
bool moves(const JointSide& side) { return side.first.norm() > 10.0 * side.error.first; }

bool have_one_direction(const JointSides& sides) {
  return moves(sides.before) && moves(sides.after) && sides.before.first.dot(sides.after.first) > 0.0;
}

}  // namespace

Continuity claim_at(const Segment& before, const Segment& after, Continuity smooth) {
  return have_one_direction(sides_between(before, after)) ? smooth : Continuity::g0;
}

Continuity claim_found(const Segment& before, const Segment& after, Continuity smooth) {
  const JointSides sides = sides_between(before, after);
  if (!have_one_direction(sides)) return Continuity::g0;
  // Relative to the curvatures alone, however slight they are.
  constexpr double no_chord = std::numeric_limits<double>::infinity();
  for (const Continuity claim : {smooth, Continuity::g1})
    if (!miss_of(sides, claim, no_chord)) return claim;
  return Continuity::g0;
}

}  // namespace kappabench
