// Similarity, mirror, reversal, cyclic shift: the curve through the changed points, changed back, is the curve.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "experiments/check/all_claims.hpp"
#include "experiments/check/same_curve.hpp"
#include "experiments/check/transformed.hpp"

namespace kappabench::check {

namespace {

void look(const SchemeUnderTest& subject, const Trial& trial, const std::string& how, const Similarity& map,
          Notes& notes) {
  const Case shown = changed(trial.shown, how, transformed(trial.shown.input, map));
  const Fit fit = subject.fit(shown.input);
  const double found = fit.curve ? deviation({spans(*trial.fit.curve), spans(transformed(*fit.curve, map.inverse())),
                                              trial.shown.input.closed, mean_chord(trial.shown.input)})
                                 : std::numeric_limits<double>::infinity();
  judge(subject, {trial, shown, fit, found}, notes);
}

Finding test_similarity(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.short_curves()) {
    const double chord = mean_chord(trial->shown.input);
    look(subject, *trial, "times 3.7, turned by 0.7", {3.7, 0.7, chord * Vec2(12.0, -5.0), false}, notes);
    look(subject, *trial, "times 1e-3, turned by 2.5", {1e-3, 2.5, Vec2::Zero(), false}, notes);
    look(subject, *trial, "times 1e4", {1e4, 0.0, Vec2::Zero(), false}, notes);
  }
  return notes.finding();
}

Finding test_mirror(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.short_curves())
    look(subject, *trial, "mirrored", {1.0, 0.4, Vec2::Zero(), true}, notes);
  return notes.finding();
}

Finding test_reversal(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.short_curves()) {
    const Input& input = trial->shown.input;
    std::vector<int> order;
    for (int i = input.size(); i-- > 0;) order.push_back(i);
    const Case shown = changed(trial->shown, "in reverse order", reversed(input, order));
    const Fit fit = subject.fit(shown.input);
    const double found =
        fit.curve ? deviation({spans(*trial->fit.curve), kappabench::reversed(with_old_names(spans(*fit.curve), order)),
                               input.closed, mean_chord(input)})
                  : std::numeric_limits<double>::infinity();
    judge(subject, {*trial, shown, fit, found}, notes);
  }
  return notes.finding();
}

Finding test_cyclic_shift(const SchemeUnderTest& subject) {
  Notes notes;
  for (const Trial* trial : subject.short_curves()) {
    const Input& input = trial->shown.input;
    if (!input.closed) continue;
    const int n = input.size();
    for (const int by : {1, n / 2}) {
      std::vector<int> order(static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i) order[static_cast<std::size_t>(i)] = (i + by) % n;
      const Case shown = changed(trial->shown, fmt::format("point {} first", by), reordered(input, order));
      const Fit fit = subject.fit(shown.input);
      const double found =
          fit.curve
              ? deviation({spans(*trial->fit.curve), with_old_names(spans(*fit.curve), order), true, mean_chord(input)})
              : std::numeric_limits<double>::infinity();
      judge(subject, {*trial, shown, fit, found}, notes);
    }
  }
  return notes.finding();
}

bool says_similarity(const SchemeTraits& traits) { return traits.similarity_invariant; }
bool says_reversal(const SchemeTraits& traits) { return traits.reversal_invariant; }
bool says_cyclic_shift(const SchemeTraits& traits) { return traits.closed && traits.cyclic_shift_invariant; }

}  // namespace

Claim similarity_claim() {
  return {"similarity", "scaled, turned, shifted points give the same curve so", says_similarity, test_similarity};
}
Claim mirror_claim() {
  return {"mirror", "part of similarity: mirrored points give the mirrored curve", says_similarity, test_mirror};
}
Claim reversal_claim() {
  return {"reversal", "the points backwards give the curve backwards", says_reversal, test_reversal};
}
Claim cyclic_shift_claim() {
  return {"cyclic shift", "closed: another first point gives the same curve", says_cyclic_shift, test_cyclic_shift};
}

}  // namespace kappabench::check
