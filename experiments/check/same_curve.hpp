#pragma once

#include <string>

#include "experiments/check/claim.hpp"
#include "metrics/correspondence.hpp"

namespace kappabench::check {

/// Where two fits are not equal bit for bit, in words: outcome, iterations, nodes, joints or jets; empty if nowhere.
[[nodiscard]] std::string difference(const Fit& a, const Fit& b);

/// A computed curve and the one that it should be, spans of both in the same coordinates.
struct Expected {
  std::vector<Span> spans;
  std::vector<Span> computed;
  bool closed;
  double chord;  ///< mean chord in these coordinates
};

/// Largest deviation over the mean chord; infinite if the curves do not meet the same points in the same order.
[[nodiscard]] double deviation(const Expected& pair);

/// What may deviate, over the mean chord, where the same curve is computed from other numbers. A scheme that minimises
/// an energy knows its minimum to the square root of rounding, for an energy is flat there: 2^-26. An input to which
/// the curve is sensitive passes that on enlarged.
inline constexpr double half_the_digits = 0x1p-26;

/// How many times farther than points that are moved by 2^-26 of the chord the curve moves; infinite if it cannot be
/// told. From 1000 on the input lies at a jump, where nothing can be said of equal curves.
[[nodiscard]] double sensitivity(const SchemeUnderTest& subject, const Fit& fit);
inline constexpr double at_a_jump = 1000.0;

/// Is `found` more than `allowed`, enlarged by the sensitivity of the input, which is measured only if it matters?
/// An input at a jump is no counterexample.
[[nodiscard]] bool deviates(const SchemeUnderTest& subject, const Fit& at, double found,
                            double allowed = half_the_digits);

/// Tells `notes` of a fit that should be the same curve: it has one and does not deviate.
struct Same {
  const Trial& original;
  Case shown;  ///< what was fitted
  Fit fit;
  double found;  ///< deviation; unused without a curve
};
void judge(const SchemeUnderTest& subject, const Same& same, Notes& notes, double allowed = half_the_digits);

}  // namespace kappabench::check
