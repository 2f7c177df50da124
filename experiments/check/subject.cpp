#include "experiments/check/subject.hpp"

#include <algorithm>
#include <exception>
#include <utility>

namespace kappabench::check {

namespace {

constexpr int short_input = 13;

template <class Work>
Fit without_throwing(const Input& input, Work work) {
  const auto crashed = [&input](const std::string& what) {
    return Fit{.input = input, .curve = std::nullopt, .report = {.outcome = Outcome::crashed, .message = what}};
  };
  try {
    return work();
  } catch (const std::exception& error) {
    return crashed(error.what());
  } catch (...) {
    return crashed("something that is no std::exception");
  }
}

std::vector<Trial> fitted(const Scheme& scheme, std::vector<Case> cases) {
  std::vector<Trial> trials;
  for (Case& next : cases) {
    Fit fit = tried_fit(scheme, next.input);
    trials.push_back({std::move(next), std::move(fit)});
  }
  return trials;
}

}  // namespace

Fit tried_fit(const Scheme& scheme, const Input& input) {
  return without_throwing(input, [&] { return scheme.fit(input); });
}

Fit tried_refit(const Scheme& scheme, const Fit& fit, const Edit& edit) {
  return without_throwing(fit.input, [&] { return scheme.refit(fit, edit); });
}

bool misses_own_claim(const Fit& fit) {
  return fit.report.outcome == Outcome::not_converged && fit.report.message.starts_with("misses its claim: ");
}

SchemeUnderTest::SchemeUnderTest(std::string text, std::function<SchemePtr()> make)
    : text_(std::move(text)),
      make_(std::move(make)),
      scheme_(make_()),
      benign_(fitted(*scheme_, benign_cases(traits()))),
      drawn_(fitted(*scheme_, drawn_cases(traits()))) {}

std::vector<const Trial*> SchemeUnderTest::trials() const {
  std::vector<const Trial*> all;
  for (const Trial& trial : benign_) all.push_back(&trial);
  for (const Trial& trial : drawn_) all.push_back(&trial);
  return all;
}

bool SchemeUnderTest::judged(const Fit& fit) const {
  return fit.curve && (fit.report.outcome == Outcome::converged || misses_own_claim(fit) || !solves());
}

std::vector<const Trial*> SchemeUnderTest::curves() const {
  std::vector<const Trial*> all = trials();
  std::erase_if(all, [this](const Trial* trial) { return !judged(trial->fit); });
  return all;
}

std::vector<const Trial*> SchemeUnderTest::short_curves() const {
  std::vector<const Trial*> chosen;
  for (const Trial& trial : benign_)
    if (judged(trial.fit) && trial.fit.input.size() <= short_input) chosen.push_back(&trial);
  return chosen;
}

long SchemeUnderTest::unsolved() const {
  return std::ranges::count_if(benign_, [](const Trial& t) { return t.fit.report.outcome != Outcome::converged; });
}

}  // namespace kappabench::check
