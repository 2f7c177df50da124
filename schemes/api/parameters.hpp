#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kappabench {

using ParameterValue = std::variant<bool, long, double, std::string>;

/// One parameter of a scheme, as `kappabench list schemes` shows it. The type is that of the default value.
struct ParameterSpec {
  std::string name;
  ParameterValue default_value;
  std::string help;  ///< one line
  /// For numbers: the allowed interval, written the way a user reads it.
  double least = -1e300;
  double most = 1e300;
  bool least_included = true;
  bool most_included = true;
  /// For text: the allowed words; empty means any.
  std::vector<std::string> choices{};
};

/// "[0.5, 1)", "true|false", "chord|centripetal": the range of a parameter in words.
[[nodiscard]] std::string range_text(const ParameterSpec& spec);

/// Throws std::invalid_argument with one line (what, and what would be right) unless `value` has the type
/// of the parameter and lies in its range.
void validate(const ParameterSpec& spec, const ParameterValue& value);

/// A full set of validated values, one for every ParameterSpec of a scheme.
class Parameters {
 public:
  /// Defaults overridden by `given`. Throws std::invalid_argument on an unknown key or a bad value.
  Parameters(std::span<const ParameterSpec> specs, const std::map<std::string, ParameterValue>& given);

  /// Parses "key=value,key=value" against the specs; same errors.
  static Parameters parse(std::span<const ParameterSpec> specs, std::string_view text);

  /// Typed access; a wrong name or type is a programming error and throws std::logic_error.
  [[nodiscard]] bool flag(std::string_view name) const;
  [[nodiscard]] long integer(std::string_view name) const;
  [[nodiscard]] double real(std::string_view name) const;
  [[nodiscard]] const std::string& text(std::string_view name) const;

  [[nodiscard]] const std::map<std::string, ParameterValue, std::less<>>& values() const { return values_; }

  /// "a=0.80000000000000004,iteration=newton": sorted keys, every parameter, 17 digits; equal text means equal
  /// parameters. Part of a cell's key in the store.
  [[nodiscard]] std::string canonical() const;

  /// Only what differs from the defaults, numbers as short as they round-trip: for people.
  [[nodiscard]] std::string brief() const;

 private:
  std::map<std::string, ParameterValue, std::less<>> values_;
  std::map<std::string, ParameterValue, std::less<>> defaults_;
};

}  // namespace kappabench
