#include "experiments/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "experiments/check/all_claims.hpp"

namespace kappabench::check {

namespace {

Finding judge(const Claim& claim, const SchemeUnderTest& subject) {
  if (!claim.says(subject.traits())) return {.verdict = Verdict::not_claimed};
  try {
    return claim.test(subject);
  } catch (const std::exception& error) {
    Notes notes;
    notes.refute({"the test", fmt::format("ends with an exception: {}", error.what()),
                  fmt::format("kappabench check {}", subject.text())});
    return notes.finding();
  }
}

}  // namespace

bool Checked::sound() const {
  return std::ranges::none_of(claims, [](const Judged& j) { return j.finding.verdict == Verdict::refuted; });
}

Checked check(const std::string& text, const std::function<SchemePtr()>& make, const Progress& progress) {
  const std::vector<Claim> claims = all_claims();
  const auto report = [&](std::size_t done, std::string_view last) {
    if (progress) progress(done, claims.size(), last);
  };
  report(0, text);
  const SchemeUnderTest subject(text, make);
  Checked checked{text, subject.info().title, {}};
  for (const Claim& claim : claims) {
    checked.claims.push_back({claim, judge(claim, subject)});
    report(checked.claims.size(), claim.name);
  }
  return checked;
}

}  // namespace kappabench::check
