#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "datasets/text.hpp"

namespace kappabench {

/// The options at the end of a generator's name, "n=12,seed=1": each key once, every key asked for by `take_*`.
class KeyValues {
 public:
  /// Empty text has no keys. `name` is the whole name, for messages. Throws DataError on what is not key=value.
  KeyValues(std::string_view text, std::string_view name);

  /// The value of a key, or its default. Throw DataError on a bad value.
  [[nodiscard]] long take_integer(std::string_view key, long default_value, long least, long most);
  [[nodiscard]] std::uint64_t take_seed();  ///< "seed", 0 to 2^63 - 1, 1 by default
  [[nodiscard]] bool take_flag(std::string_view key, bool default_value);
  [[nodiscard]] std::string take_word(std::string_view key, std::string_view default_value);

  /// Throws DataError if a key was not taken; `known` lists the right ones.
  void expect_all_taken(std::string_view known) const;

  [[nodiscard]] const Place& place() const { return place_; }

 private:
  Place place_;
  std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace kappabench
