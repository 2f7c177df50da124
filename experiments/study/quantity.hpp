#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "metrics/metric.hpp"

namespace kappabench::study {

/// What stands in a key's column: a word or a number.
using KeyValue = std::variant<double, std::string>;

[[nodiscard]] KeyValue key_value(std::integral auto number) { return static_cast<double>(number); }
[[nodiscard]] KeyValue key_value(std::floating_point auto number) { return static_cast<double>(number); }
[[nodiscard]] inline KeyValue key_value(std::string_view word) { return std::string(word); }

/// One entry of a row: this key has this value.
struct KeyIs {
  std::string name;
  KeyValue value;
};

/// What tells rows apart: the joint, the point, the parameter. `joint(3)` is one entry of a row.
struct Key {
  std::string name;

  template <class Value>
  [[nodiscard]] KeyIs operator()(const Value& value) const {
    return {name, key_value(value)};
  }
};

/// One measured number of a row.
struct Reading {
  std::string name, unit;
  Method method;
  double value;
};

/// A measured quantity: its name in the results file, its unit and how it is got, said once. Cells put it and
/// conclusions read it through this value alone, so that no name can be misspelt and no method forgotten.
/// `gap(0.1)` is one number of a row.
struct Quantity {
  std::string name;
  std::string unit;  ///< "1", "rad", "1/length", ...
  Method method;

  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  [[nodiscard]] Reading operator()(Number value) const { return {name, unit, method, static_cast<double>(value)}; }
};

/// A number of things counted one by one.
[[nodiscard]] inline Quantity count_of(std::string name) { return {std::move(name), "1", Method::exact}; }

}  // namespace kappabench::study
