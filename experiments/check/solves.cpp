#include <fmt/format.h>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  notes.count("fits", static_cast<long>(subject.benign().size()));
  if (subject.unsolved() > 0) notes.say(fmt::format("{} did not converge", subject.unsolved()));
  if (!subject.solves())
    for (const Trial& trial : subject.benign())
      if (trial.fit.report.outcome != Outcome::converged)
        notes.refute({trial.shown.name,
                      fmt::format("{}: {}", kappabench::name(trial.fit.report.outcome), trial.fit.report.message),
                      fit_command(trial.shown, subject.text())});
  return notes.finding();
}

}  // namespace

Claim solves_claim() { return {"solves", "9 of 10 random stars and walks of 5 to 24 points converge", always, test}; }

}  // namespace kappabench::check
