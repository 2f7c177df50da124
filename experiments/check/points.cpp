#include <fmt/format.h>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

bool refused(const Fit& fit) { return fit.report.outcome == Outcome::unsupported_input; }

void look(const SchemeUnderTest& subject, bool closed, bool claimed, int fewest, Notes& notes) {
  const auto expect = [&](const Case& next, bool taken) {
    notes.count("fits");
    const Fit fit = subject.fit(next.input);
    if (taken ? fit.curve.has_value() : refused(fit)) return;
    notes.refute(
        {next.name,
         fmt::format("{} ({}); {} curves are{} claimed, from {} points on", kappabench::name(fit.report.outcome),
                     fit.report.message, closed ? "closed" : "open", claimed ? "" : " not", fewest),
         fit_command(next, subject.text())});
  };
  for (const int seed : {1, 2, 3}) {
    if (!claimed) {
      expect(random_star(9, seed, closed), false);
      continue;
    }
    expect(random_star(fewest, seed, closed), true);
    if (fewest > 1) expect(random_star(fewest - 1, seed, closed), false);
  }
}

/// Points that repeat are taken if that is claimed, and refused else.
void look_at_repeats(const SchemeUnderTest& subject, bool closed, Notes& notes) {
  Case repeated = random_star(8, 1, closed);
  repeated.input.points[4] = repeated.input.points[3];
  repeated = changed(repeated, "point 3 twice", repeated.input);
  const Fit fit = subject.fit(repeated.input);
  notes.count("fits");
  if (subject.traits().repeats_allowed ? fit.curve.has_value() : refused(fit)) return;
  notes.refute({repeated.name,
                fmt::format("{} ({}); repeats are{} claimed", kappabench::name(fit.report.outcome), fit.report.message,
                            subject.traits().repeats_allowed ? "" : " not"),
                fit_command(repeated, subject.text())});
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const SchemeTraits& traits = subject.traits();
  look(subject, false, traits.open, traits.fewest_open_points, notes);
  look(subject, true, traits.closed, traits.fewest_closed_points, notes);
  if (traits.open) look_at_repeats(subject, false, notes);
  if (traits.closed) look_at_repeats(subject, true, notes);
  const auto from = [](bool claimed, int fewest) { return claimed ? fmt::format("from {}", fewest) : "no"; };
  notes.say(fmt::format("open {}, closed {}", from(traits.open, traits.fewest_open_points),
                        from(traits.closed, traits.fewest_closed_points)));
  return notes.finding();
}

}  // namespace

Claim points_claim() {
  return {"points", "open, closed, fewest points and repeats are taken or refused as said", always, test};
}

}  // namespace kappabench::check
