#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "experiments/check/all_claims.hpp"
#include "experiments/check/same_curve.hpp"
#include "experiments/check/transformed.hpp"

namespace kappabench::check {

namespace {

constexpr double far_away = 1e9;   // chords
constexpr std::size_t inputs = 6;  // each fitted three times

void look(const SchemeUnderTest& subject, const Trial& trial, const std::string& how, const Similarity& map,
          double allowed, Notes& notes) {
  const Input& input = trial.shown.input;
  const Case shown = changed(trial.shown, how, transformed(input, map));
  const Fit fit = subject.fit(shown.input);
  // So far out rounding alone can make a curve miss what it keeps at home: the framework says so, and rightly.
  if (map.shift != Vec2::Zero() && misses_own_claim(fit) && trial.fit.report.outcome == Outcome::converged) {
    notes.count("lost to rounding");
    return;
  }
  const double found = fit.curve ? deviation({spans(*trial.fit.curve), spans(transformed(*fit.curve, map.inverse())),
                                              input.closed, mean_chord(input)})
                                 : std::numeric_limits<double>::infinity();
  judge(subject, {trial, shown, fit, found}, notes, allowed);
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  std::vector<const Trial*> chosen = subject.short_curves();
  chosen.resize(std::min(chosen.size(), inputs));
  for (const Trial* trial : chosen) {
    const Vec2 shift = far_away * mean_chord(trial->shown.input) * Vec2(1.0, -0.5);
    look(subject, *trial, "times 1e-150", {1e-150, 0.0, Vec2::Zero(), false}, half_the_digits, notes);
    look(subject, *trial, "times 1e150", {1e150, 0.0, Vec2::Zero(), false}, half_the_digits, notes);
    // Every operation on coordinates rounds to 2^-53 of them, and some tens of them make a point of the curve.
    look(subject, *trial, "1e9 chords away", {1.0, 0.0, shift, false}, 32.0 * 0x1p-53 * far_away, notes);
  }
  return notes.finding();
}

bool says(const SchemeTraits& traits) { return traits.similarity_invariant; }

}  // namespace

Claim far_claim() { return {"far", "the same curve at sizes 1e-150 and 1e150, and 1e9 chords away", says, test}; }

}  // namespace kappabench::check
