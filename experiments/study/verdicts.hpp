#pragma once

#include <string>

namespace kappabench::study {

/// How counts become verdicts on what a paper claims, by the same rules for every paper.

/// Share of cases that agree, "1234 of 1240 (99.5 %)".
[[nodiscard]] std::string share(double agree, double cases);

/// For a statement about a single thing: nothing is shown where that is not there.
[[nodiscard]] std::string verdict_for_one(bool there, bool holds);
/// For a statement about every case: one counterexample contradicts it; nothing is shown by no case.
[[nodiscard]] std::string verdict_for_all(double counterexamples, double cases);
/// For a statement about what generally happens: reproduced from 95 % of the cases, contradicted below half.
[[nodiscard]] std::string verdict_in_general(double agree, double cases);

/// For a statement about what happens often or tends to happen: reproduced from two thirds of the cases, contradicted
/// below half.
[[nodiscard]] std::string verdict_often(double agree, double cases);

}  // namespace kappabench::study
