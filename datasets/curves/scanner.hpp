#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "datasets/text.hpp"

namespace kappabench {

/// Reads the little languages of SVG attributes, path data and transforms, from left to right. What is wrong is refused
/// (DataError) with the line that it is on.
class Scanner {
 public:
  /// `start`: where the text starts.
  Scanner(std::string_view text, Place start) : rest_(text), place_(std::move(start)) {}

  /// Steps over blanks; true if nothing else is left.
  [[nodiscard]] bool done();
  /// Steps over blanks and at most one comma.
  void skip_separator();
  /// The next character, which is stepped over if it is this one.
  [[nodiscard]] bool take(char c);
  [[nodiscard]] char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  /// The letters that follow.
  [[nodiscard]] std::string_view word();
  /// Does a number follow?
  [[nodiscard]] bool at_number() const;
  /// A finite number as SVG writes it (".5", "-1e-3"), as far as one goes: "1-2" are two, ".5.5" too.
  [[nodiscard]] double number(std::string_view what);
  /// A flag of an arc: one character, 0 or 1, that need not be set off from what follows.
  [[nodiscard]] bool flag(std::string_view what);

  /// Where the text is read.
  [[nodiscard]] const Place& place() const { return place_; }
  /// In quotes, the text from here on, for messages.
  [[nodiscard]] std::string next() const;

 private:
  void skip_blanks();

  std::string_view rest_;
  Place place_;
};

}  // namespace kappabench
