#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/check/subject.hpp"

namespace kappabench::check {

enum class Verdict {
  held,
  refuted,
  not_claimed,
  not_tried  ///< claimed, but there was nothing to try it on
};

/// "held", "refuted", "not claimed", "not tried".
[[nodiscard]] std::string_view name(Verdict verdict);

/// Where a claim broke.
struct Refutation {
  std::string where;    ///< the drawing, and the place in it
  std::string numbers;  ///< both sides: what was found, and what was allowed or expected
  std::string command;  ///< one line for the shell that shows it
};

/// How much of something was tried.
struct Count {
  std::string what;  ///< "fits", "joints", ...
  long number;
};

struct Finding {
  Verdict verdict = Verdict::not_tried;
  std::vector<Count> tried{};
  std::string note{};                     ///< what was measured, if it is worth a word
  long refuted = 0;                       ///< how often
  std::vector<Refutation> refutations{};  ///< the first few: the smallest inputs
};

/// Something that a scheme says of itself, and how to find out.
struct Claim {
  std::string name;
  std::string meaning;  ///< half a line
  bool (*says)(const SchemeTraits& traits);
  Finding (*test)(const SchemeUnderTest& subject);
};

/// The claim that is made by being a scheme.
[[nodiscard]] inline bool always(const SchemeTraits&) { return true; }

/// Counts while a claim is tried, and becomes its finding.
class Notes {
 public:
  void count(std::string_view what, long number = 1);
  void refute(Refutation refutation);
  void say(std::string note) { finding_.note = std::move(note); }

  /// Held if something was tried and nothing refuted.
  [[nodiscard]] Finding finding() const;

 private:
  Finding finding_;
};

}  // namespace kappabench::check
