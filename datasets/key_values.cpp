#include "datasets/key_values.hpp"

#include <fmt/format.h>

#include <limits>

namespace kappabench {

KeyValues::KeyValues(std::string_view text, std::string_view name) : place_{std::string(name), 0} {
  if (text.empty()) return;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == part.npos)
      refuse(place_, fmt::format("{} is no option", in_quotes(part)), "write key=value,key=value");
    const auto [at, added] = values_.emplace(part.substr(0, equals), part.substr(equals + 1));
    if (!added) refuse(place_, fmt::format("{} is given twice", in_quotes(at->first)), "give it once");
  }
}

std::string KeyValues::take_word(std::string_view key, std::string_view default_value) {
  const auto found = values_.find(key);
  if (found == values_.end()) return std::string(default_value);
  return values_.extract(found).mapped();
}

long KeyValues::take_integer(std::string_view key, long default_value, long least, long most) {
  return parse_integer(take_word(key, fmt::format("{}", default_value)), key, least, most, place_);
}

std::uint64_t KeyValues::take_seed() {
  return static_cast<std::uint64_t>(take_integer("seed", 1, 0, std::numeric_limits<long>::max()));
}

bool KeyValues::take_flag(std::string_view key, bool default_value) {
  return parse_flag(take_word(key, default_value ? "true" : "false"), key, place_);
}

void KeyValues::expect_all_taken(std::string_view known) const {
  if (values_.empty()) return;
  refuse(place_, fmt::format("unknown option {}", in_quotes(values_.begin()->first)),
         fmt::format("known are {}", known));
}

}  // namespace kappabench
