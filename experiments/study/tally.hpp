#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/study/verdicts.hpp"

namespace kappabench::study {

/// How many of the cases agree with a statement, and the verdict that follows by its kind (verdicts.hpp).
struct Tally {
  double agree = 0.0, cases = 0.0;

  void add(bool holds) {
    cases += 1.0;
    agree += holds ? 1.0 : 0.0;
  }
  Tally& operator+=(const Tally& other) {
    agree += other.agree;
    cases += other.cases;
    return *this;
  }
  [[nodiscard]] double misses() const { return cases - agree; }
  [[nodiscard]] double share() const { return agree / cases; }                    ///< NaN of no case
  [[nodiscard]] std::string words() const { return study::share(agree, cases); }  ///< "1234 of 1240 (99.5 %)"
  [[nodiscard]] std::string always() const { return verdict_for_all(misses(), cases); }
  [[nodiscard]] std::string in_general() const { return verdict_in_general(agree, cases); }
  [[nodiscard]] std::string often() const { return verdict_often(agree, cases); }
};

/// How many of the numbers satisfy `holds`; without it, how many are not 0.
template <class Holds = std::identity>
[[nodiscard]] Tally tally_of(const std::vector<double>& numbers, Holds holds = {}) {
  Tally tally;
  for (const double number : numbers) tally.add(static_cast<bool>(holds(number)));
  return tally;
}

}  // namespace kappabench::study
