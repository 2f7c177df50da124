#pragma once

#include <string>
#include <vector>

#include "experiments/study/tally.hpp"
#include "reports/paper.hpp"

namespace kappabench::study {

/// How samples become verdicts on what a paper states: one rule for each kind of statement, the same for every paper.
///
/// - always: one counterexample contradicts it, however many cases agree.
/// - in general: reproduced if at least 95 % of all cases agree, contradicted if less than half do.
/// - often: the same with two thirds.
/// - may: one case reproduces it. None among 200 or more do not.
/// - growth, number: reproduced between the bounds of the paper's file. Outside of them a growth is contradicted, a
///   number not reproduced.
///
/// "Of all cases" is what the sample says of them at 95 % confidence, cases taken for independent: an interval on both
/// sides of a bound leaves the statement undecided, and so does a sample without cases.

/// Of a share, or of a measured number.
struct Interval {
  double low, high;
};

/// Wilson's interval of a share at 95 % confidence (Probable inference, the law of succession, and statistical
/// inference, J. Am. Stat. Assoc. 22, 1927). From 0 to 1 of no case.
[[nodiscard]] Interval wilson(const Tally& sample);

/// The median of all of which this is a sample, at 95 % confidence, whatever their distribution: a number is below it
/// with chance 1/2, so it lies between the quantiles at the ends of the interval of that share. NaNs are left out.
[[nodiscard]] Interval interval_of_median(std::vector<double> sample);

/// A verdict, and what it was got by, in words.
struct Ruling {
  std::string verdict, sample, interval, rule;
};

/// For the kinds always, in general, often, may.
[[nodiscard]] Ruling ruling(StatementKind kind, const Tally& sample);
/// For growth and number; the interval may be one number.
[[nodiscard]] Ruling ruling(const PrintedClaim& claim, const Interval& measured);
/// For a formula whose printed form fails and that holds corrected. A printed form that holds is reproduced; a
/// corrected one that fails too is no misprint but contradicted.
[[nodiscard]] Ruling ruling_on_formula(const Tally& printed, const Tally& corrected);

}  // namespace kappabench::study
