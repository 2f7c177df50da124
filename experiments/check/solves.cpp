#include <fmt/format.h>

#include <algorithm>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  notes.count("benign", static_cast<long>(subject.benign().size()));
  notes.count("drawings", static_cast<long>(subject.drawn().size()));
  const auto refute = [&](const Trial& trial) {
    notes.refute({trial.shown.name,
                  fmt::format("{}: {}", kappabench::name(trial.fit.report.outcome), trial.fit.report.message),
                  fit_command(trial.shown, subject.text())});
  };
  for (const Trial& trial : subject.benign())
    if (misses_own_claim(trial.fit) || (!subject.solves() && trial.fit.report.outcome != Outcome::converged))
      refute(trial);
  // Drawings may be hard to solve; what is solved must be what was claimed.
  for (const Trial& trial : subject.drawn())
    if (misses_own_claim(trial.fit)) refute(trial);
  const auto unsolved = std::ranges::count_if(
      subject.drawn(), [](const Trial& trial) { return trial.fit.report.outcome != Outcome::converged; });
  if (subject.unsolved() + unsolved > 0)
    notes.say(fmt::format("{} and {} did not converge", subject.unsolved(), unsolved));
  return notes.finding();
}

}  // namespace

Claim solves_claim() {
  return {"solves", "9 of 10 benign inputs converge; no curve misses its own claim", always, test};
}

}  // namespace kappabench::check
