#include "metrics/continuity.hpp"

#include <fmt/format.h>

#include "experiments/check/all_claims.hpp"
#include "schemes/api/frame.hpp"

namespace kappabench::check {

namespace {

/// Does a joint of this claim do what the scheme promises of all?
bool implies(Continuity joint, Continuity promised) {
  using enum Continuity;
  if (joint == promised || promised == g0 || joint == c2) return true;
  if (promised == g1) return joint != g0;
  return promised == g1_equal_magnitude && joint == g2;
}

std::string numbers(const JointJump& jump) {
  return fmt::format(
      "claims {}; gap {:.2g} chords, angle {:.2g} rad, curvature {:.2g}, |curvature| {:.2g}, c' {:.2g}, "
      "c'' {:.2g} (relative)",
      kappabench::name(jump.joint.claimed), jump.gap, jump.angle, jump.curvature, jump.curvature_magnitude,
      jump.first_derivative, jump.second_derivative);
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const SchemeTraits& traits = subject.traits();
  long as_promised = 0, joints = 0;
  for (const Trial* trial : subject.curves()) {
    notes.count("curves");
    const Fit local = place(trial->fit, frame_of(trial->fit.input).inverse());
    for (const JointJump& jump : joint_jumps(*local.curve, local.input)) {
      notes.count("joints");
      ++joints;
      const Refutation place{fmt::format("{}, end of segment {}", trial->shown.name, jump.joint.segment), numbers(jump),
                             fit_command(trial->shown, subject.text())};
      const bool promised = implies(jump.joint.claimed, traits.continuity);
      if (promised) ++as_promised;
      if (!jump.meets_claim || (!promised && traits.continuity_exceptions.empty())) notes.refute(place);
    }
  }
  notes.say(fmt::format("{}{}", kappabench::name(traits.continuity),
                        as_promised == joints ? "" : fmt::format(", {} exceptions", joints - as_promised)));
  if (joints > 0 && as_promised == 0)
    notes.refute({"every joint",
                  fmt::format("none claims {}, what the scheme does", kappabench::name(traits.continuity)),
                  "kappabench list schemes --json"});
  return notes.finding();
}

}  // namespace

Claim continuity_claim() { return {"continuity", "every joint is as smooth as it and the scheme claim", always, test}; }

}  // namespace kappabench::check
