#pragma once

#include <functional>
#include <string>
#include <vector>

namespace kappabench::study {

/// Share of cases that agree, "1234 of 1240 (99.5 %)".
[[nodiscard]] std::string share(double agree, double cases);

/// How many of the cases agree with a statement.
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
};

/// All of the cases but these agree.
[[nodiscard]] inline Tally all_but(double misses, double cases) { return {cases - misses, cases}; }

/// The one case that there is, if there is one.
[[nodiscard]] inline Tally one_case(bool there, bool holds) { return there ? Tally{holds ? 1.0 : 0.0, 1.0} : Tally{}; }

/// The weaker of two: the one that agrees less often.
[[nodiscard]] inline Tally weaker(const Tally& a, const Tally& b) {
  return a.agree * b.cases < b.agree * a.cases ? a : b;
}

/// How many of the numbers satisfy `holds`; without it, how many are not 0.
template <class Holds = std::identity>
[[nodiscard]] Tally tally_of(const std::vector<double>& numbers, Holds holds = {}) {
  Tally tally;
  for (const double number : numbers) tally.add(static_cast<bool>(holds(number)));
  return tally;
}

}  // namespace kappabench::study
