#include "experiments/study/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "metrics/statistics.hpp"

namespace kappabench::study {

namespace {

constexpr double half = 0.5;
constexpr double enough = 200.0;  ///< cases, to say that something that may be is not

std::string percent(const Interval& share) {
  return fmt::format("{:.3g} % to {:.3g} %", 100.0 * share.low, 100.0 * share.high);
}

Ruling judged_always(const Tally& sample) {
  if (sample.misses() > 0.0) return {"contradicted", sample.words(), "", "one counterexample contradicts"};
  const double failing = 1.0 - wilson(sample).low;
  return {"reproduced", sample.words(), fmt::format("at most {:.2g} % of all cases fail", 100.0 * failing),
          "one counterexample contradicts"};
}

/// A statement that holds for most cases, `least` of them.
Ruling judged_share(const Tally& sample, double least) {
  const Interval all = wilson(sample);
  const std::string verdict = all.low >= least   ? "reproduced"
                              : all.high < half  ? "contradicted"
                              : all.high < least ? "not reproduced"
                                                 : "undecided";
  return {verdict, sample.words(), percent(all),
          fmt::format("reproduced from {:.3g} %, contradicted below 50 %", 100.0 * least)};
}

Ruling judged_may(const Tally& sample) {
  const std::string verdict = sample.agree > 0.0       ? "reproduced"
                              : sample.cases >= enough ? "not reproduced"
                                                       : "undecided";
  return {verdict, sample.words(), percent(wilson(sample)),
          fmt::format("one case reproduces, none of {:.0f} does not", enough)};
}

std::string words(double low, double high) {
  if (std::isinf(high)) return fmt::format("from {:.4g}", low);
  if (std::isinf(low)) return fmt::format("up to {:.4g}", high);
  return low == high ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} to {:.4g}", low, high);
}

}  // namespace

Interval wilson(const Tally& sample) {
  const auto& [agree, cases] = sample;
  if (!(cases > 0.0)) return {0.0, 1.0};
  const double z = boost::math::quantile(boost::math::normal(), 0.975), zz = z * z / cases;
  const double p = agree / cases, middle = (p + 0.5 * zz) / (1.0 + zz);
  const double reach = std::sqrt((p * (1.0 - p) + 0.25 * zz) * zz) / (1.0 + zz);
  return {agree == 0.0 ? 0.0 : std::max(0.0, middle - reach), agree == cases ? 1.0 : std::min(1.0, middle + reach)};
}

Interval interval_of_median(std::vector<double> sample) {
  std::erase_if(sample, [](double v) { return std::isnan(v); });
  const auto n = static_cast<double>(sample.size());
  const auto [low, high] = wilson({0.5 * n, n});
  return {quantile(sample, low), quantile(sample, high)};
}

Ruling ruling(StatementKind kind, const Tally& sample) {
  if (!(sample.cases > 0.0)) return {"undecided", "no case", "", "a verdict needs cases"};
  switch (kind) {
    case StatementKind::always:
      return judged_always(sample);
    case StatementKind::in_general:
      return judged_share(sample, 0.95);
    case StatementKind::often:
      return judged_share(sample, 2.0 / 3.0);
    case StatementKind::may:
      return judged_may(sample);
    case StatementKind::growth:
    case StatementKind::number:
      break;
  }
  throw std::logic_error(fmt::format("a statement of the kind '{}' is judged by a number", name(kind)));
}

Ruling ruling(const PrintedClaim& claim, const Interval& measured) {
  const bool growth = claim.kind == StatementKind::growth;
  if (!growth && claim.kind != StatementKind::number)
    throw std::logic_error(
        fmt::format("claim {}: a statement of the kind '{}' is judged by cases", claim.id, name(claim.kind)));
  if (std::isnan(measured.low) || std::isnan(measured.high)) return {"undecided", "", "", "a verdict needs a number"};
  const bool inside = measured.low >= claim.at_least && measured.high <= claim.at_most;
  const bool outside = measured.high < claim.at_least || measured.low > claim.at_most;
  const std::string verdict = inside     ? "reproduced"
                              : !outside ? "undecided"
                              : growth   ? "contradicted"
                                         : "not reproduced";
  return {verdict, "", words(measured.low, measured.high),
          fmt::format("reproduced {}", words(claim.at_least, claim.at_most))};
}

Ruling ruling_on_formula(const Tally& printed, const Tally& corrected) {
  const bool any = printed.cases > 0.0 && corrected.cases > 0.0;
  const std::string verdict = !any                        ? "undecided"
                              : printed.misses() == 0.0   ? "reproduced"
                              : corrected.misses() == 0.0 ? "misprint"
                                                          : "contradicted";
  return {verdict, fmt::format("printed {}, corrected {}", printed.words(), corrected.words()), "",
          "a misprint fails as printed and never corrected"};
}

}  // namespace kappabench::study
