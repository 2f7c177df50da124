#include "experiments/check/claim.hpp"

#include <algorithm>
#include <stdexcept>

namespace kappabench::check {

namespace {

constexpr std::size_t most_refutations = 3;  // that a person reads of one claim

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::held:
      return "held";
    case Verdict::refuted:
      return "refuted";
    case Verdict::not_claimed:
      return "not claimed";
    case Verdict::not_tried:
      return "not tried";
  }
  throw std::logic_error("name(Verdict): not a value of the enumeration");
}

void Notes::count(std::string_view what, long number) {
  const auto found = std::ranges::find(finding_.tried, what, &Count::what);
  if (found == finding_.tried.end())
    finding_.tried.push_back({std::string(what), number});
  else
    found->number += number;
}

void Notes::refute(Refutation refutation) {
  ++finding_.refuted;
  if (finding_.refutations.size() < most_refutations) finding_.refutations.push_back(std::move(refutation));
}

Finding Notes::finding() const {
  Finding result = finding_;
  const bool tried = std::ranges::any_of(result.tried, [](const Count& c) { return c.number > 0; });
  if (result.refuted > 0)
    result.verdict = Verdict::refuted;
  else
    result.verdict = tried ? Verdict::held : Verdict::not_tried;
  return result;
}

}  // namespace kappabench::check
