#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

bool finite(const Curve& curve) {
  return std::ranges::all_of(sample(curve, 9, max_jet_order).jets, [](const Jet& jet) {
    return std::ranges::all_of(jet.d, [](const Vec2& d) { return d.allFinite(); });
  });
}

/// What is wrong with the answer as such, whatever the curve is like; empty if nothing.
std::string fault(const Fit& fit) {
  using enum Outcome;
  const Outcome outcome = fit.report.outcome;
  const std::string& message = fit.report.message;
  if (outcome == crashed) return fmt::format("throws: {}", message);
  if (message.find('\n') != std::string::npos) return "the message has more than one line";
  if (outcome != converged && message.empty())
    return fmt::format("{} without a message; one line says why", kappabench::name(outcome));
  if (outcome == converged && !fit.curve) return "converged without a curve";
  if ((outcome == unsupported_input || outcome == failed) && fit.curve)
    return fmt::format("{} with a curve; there should be none", kappabench::name(outcome));
  if (fit.curve && !finite(*fit.curve)) return "the curve is not finite: its jets hold NaN or infinity";
  if (fit.curve && fit.curve->closed() != fit.input.closed)
    return fmt::format("the curve is {}, the input {}", fit.curve->closed() ? "closed" : "open",
                       fit.input.closed ? "closed" : "open");
  return {};
}

Finding test(const SchemeUnderTest& subject) {
  Notes notes;
  const auto look = [&](const Case& shown, const Fit& fit) {
    notes.count("fits");
    if (const std::string what = fault(fit); !what.empty())
      notes.refute({shown.name, what, fit_command(shown, subject.text())});
  };
  for (const Case& next : hostile_cases()) {
    notes.count("hostile");
    look(next, subject.fit(next.input));
  }
  for (const Trial* trial : subject.trials()) look(trial->shown, trial->fit);
  return notes.finding();
}

}  // namespace

Claim outcome_claim() {
  return {"outcome", "any input: a finite curve or one line that says why not; no throw", always, test};
}

}  // namespace kappabench::check
