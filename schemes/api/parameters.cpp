#include "schemes/api/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "schemes/api/known_words.hpp"

namespace kappabench {

namespace {

/// Visitor made of lambdas.
template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

[[noreturn]] void refuse(const std::string& line) { throw std::invalid_argument(line); }

std::string shortest(const ParameterValue& value) {
  return std::visit(
      Overloaded{[](bool flag) { return std::string(flag ? "true" : "false"); },
                 [](long integer) { return fmt::format("{}", integer); },
                 [](double real) { return fmt::format("{}", real); }, [](const std::string& text) { return text; }},
      value);
}

std::string known_names(std::string_view name, std::span<const ParameterSpec> specs) {
  if (specs.empty()) return "it has no parameters";
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const ParameterSpec& spec : specs) names.push_back(spec.name);
  return known_words(name, names);
}

const ParameterSpec& spec_of(std::span<const ParameterSpec> specs, std::string_view name) {
  const auto found = std::ranges::find(specs, name, &ParameterSpec::name);
  if (found == specs.end()) refuse(fmt::format("unknown parameter '{}'; {}", name, known_names(name, specs)));
  return *found;
}

template <class Number>
ParameterValue parse_number(const ParameterSpec& spec, std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size())
    refuse(fmt::format("{}={}: not a number; allowed is {}", spec.name, text, range_text(spec)));
  return number;
}

ParameterValue parse_value(const ParameterSpec& spec, std::string_view text) {
  return std::visit(Overloaded{[&](bool) -> ParameterValue {
                                 if (text == "true") return true;
                                 if (text == "false") return false;
                                 refuse(fmt::format("{}={}: allowed is true|false", spec.name, text));
                               },
                               [&](long) { return parse_number<long>(spec, text); },
                               [&](double) { return parse_number<double>(spec, text); },
                               [&](const std::string&) -> ParameterValue { return std::string(text); }},
                    spec.default_value);
}

bool in_range(const ParameterSpec& spec, double value) {
  const bool above = spec.least_included ? value >= spec.least : value > spec.least;
  const bool below = spec.most_included ? value <= spec.most : value < spec.most;
  return std::isfinite(value) && above && below;
}

}  // namespace

std::string range_text(const ParameterSpec& spec) {
  const auto interval = [&spec](std::string_view kind) {
    const bool no_least = spec.least <= -1e300, no_most = spec.most >= 1e300;
    if (no_least && no_most) return std::string(kind);
    return fmt::format("{} in {}{}, {}{}", kind, spec.least_included && !no_least ? '[' : '(',
                       no_least ? "-inf" : fmt::format("{:.4g}", spec.least),
                       no_most ? "inf" : fmt::format("{:.4g}", spec.most), spec.most_included && !no_most ? ']' : ')');
  };
  return std::visit(
      Overloaded{[](bool) { return std::string("true|false"); }, [&](long) { return interval("an integer"); },
                 [&](double) { return interval("a number"); },
                 [&](const std::string&) {
                   return spec.choices.empty() ? std::string("text") : fmt::format("{}", fmt::join(spec.choices, "|"));
                 }},
      spec.default_value);
}

void validate(const ParameterSpec& spec, const ParameterValue& value) {
  const bool valid = value.index() == spec.default_value.index() &&
                     std::visit(Overloaded{[](bool) { return true; },
                                           [&](long integer) { return in_range(spec, static_cast<double>(integer)); },
                                           [&](double real) { return in_range(spec, real); },
                                           [&](const std::string& text) {
                                             return spec.choices.empty() ||
                                                    std::ranges::find(spec.choices, text) != spec.choices.end();
                                           }},
                                value);
  if (!valid) refuse(fmt::format("{}={}: allowed is {}", spec.name, shortest(value), range_text(spec)));
}

Parameters::Parameters(std::span<const ParameterSpec> specs, const std::map<std::string, ParameterValue>& given) {
  for (const ParameterSpec& spec : specs) defaults_.emplace(spec.name, spec.default_value);
  values_ = defaults_;
  for (const auto& [name, value] : given) {
    validate(spec_of(specs, name), value);
    values_.insert_or_assign(name, value);
  }
}

Parameters Parameters::parse(std::span<const ParameterSpec> specs, std::string_view text) {
  std::map<std::string, ParameterValue> given;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos || equals == 0)
      refuse(fmt::format("'{}': a parameter is written key=value; {}", item, known_names(item, specs)));
    const ParameterSpec& spec = spec_of(specs, item.substr(0, equals));
    if (!given.emplace(spec.name, parse_value(spec, item.substr(equals + 1))).second)
      refuse(fmt::format("parameter '{}' is given twice", spec.name));
  }
  return {specs, given};
}

namespace {

template <class T>
const T& typed(const std::map<std::string, ParameterValue, std::less<>>& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end() || !std::holds_alternative<T>(found->second))
    throw std::logic_error(fmt::format("Parameters: '{}' is not declared with this type", name));
  return std::get<T>(found->second);
}

}  // namespace

bool Parameters::flag(std::string_view name) const { return typed<bool>(values_, name); }
long Parameters::integer(std::string_view name) const { return typed<long>(values_, name); }
double Parameters::real(std::string_view name) const { return typed<double>(values_, name); }
const std::string& Parameters::text(std::string_view name) const { return typed<std::string>(values_, name); }

std::string Parameters::canonical() const {
  std::vector<std::string> items;
  for (const auto& [name, value] : values_) {
    const double* real = std::get_if<double>(&value);
    items.push_back(fmt::format("{}={}", name, real ? fmt::format("{:.17g}", *real) : shortest(value)));
  }
  return fmt::format("{}", fmt::join(items, ","));
}

std::string Parameters::brief() const {
  std::vector<std::string> items;
  for (const auto& [name, value] : values_)
    if (value != defaults_.at(name)) items.push_back(fmt::format("{}={}", name, shortest(value)));
  return fmt::format("{}", fmt::join(items, ","));
}

}  // namespace kappabench
