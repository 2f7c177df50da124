#include <fmt/format.h>

#include <algorithm>

#include "experiments/check/all_claims.hpp"
#include "experiments/check/same_curve.hpp"

namespace kappabench::check {

namespace {

constexpr std::size_t inputs = 12;

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const std::vector<Trial>& trials = subject.benign();
  const auto expect = [&](const Trial& trial, const Fit& again, std::string_view how) {
    notes.count("fits");
    if (const std::string what = difference(trial.fit, again); !what.empty())
      notes.refute({fmt::format("{}, {}", trial.shown.name, how), what, fit_command(trial.shown, subject.text())});
  };
  const SchemePtr another = subject.another();
  for (std::size_t i = 0; i < trials.size() && i < inputs; ++i) {
    // The first fit of it came after the fits of the inputs before, this one comes after those of all others.
    expect(trials[i], subject.fit(trials[i].shown.input), "after other inputs");
    expect(trials[i], subject.fit(trials[i].shown.input), "twice in a row");
    expect(trials[i], tried_fit(*subject.another(), trials[i].shown.input), "by a new instance");
  }
  for (std::size_t i = std::min(inputs, trials.size()); i-- > 0;)
    expect(trials[i], tried_fit(*another, trials[i].shown.input), "by another instance, inputs in reverse order");
  return notes.finding();
}

}  // namespace

Claim determinism_claim() {
  return {"determinism", "equal bit for bit: again, by a new instance, after other inputs", always, test};
}

}  // namespace kappabench::check
